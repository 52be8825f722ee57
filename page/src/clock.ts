/** One clock for all players and series of a comparison. */

export const speeds = [0.1, 0.25, 0.5, 1, 2, 4];

type Listener = (time: number) => void;

export class Clock {
  time = 0;
  end = 0;
  speed = 0.5;
  playing = false;
  private last = 0;
  private readonly onTime: Listener[] = [];
  private readonly onState: (() => void)[] = [];

  /** Calls the listener with every new time; gives back what ends that. */
  watch(listener: Listener): () => void {
    this.onTime.push(listener);
    return () => this.onTime.splice(this.onTime.indexOf(listener), 1);
  }

  watchState(listener: () => void): void {
    this.onState.push(listener);
  }

  /** The latest end of what is played [s]. */
  setEnd(end: number): void {
    this.end = end;
    this.set(Math.min(this.time, end));
    this.onState.forEach((tell) => tell());
  }

  set(time: number): void {
    this.time = Math.min(this.end, Math.max(0, time));
    [...this.onTime].forEach((tell) => tell(this.time));
  }

  setSpeed(speed: number): void {
    this.speed = speed;
    this.onState.forEach((tell) => tell());
  }

  play(): void {
    if (this.playing || this.end === 0) return;
    if (this.time >= this.end) this.set(0);
    this.playing = true;
    this.last = performance.now();
    requestAnimationFrame((now) => this.tick(now));
    this.onState.forEach((tell) => tell());
  }

  pause(): void {
    this.playing = false;
    this.onState.forEach((tell) => tell());
  }

  private tick(now: number): void {
    if (!this.playing) return;
    const passed = Math.min(0.1, (now - this.last) / 1000);
    this.last = now;
    this.set(this.time + passed * this.speed);
    if (this.time >= this.end) this.pause();
    else requestAnimationFrame((next) => this.tick(next));
  }
}
