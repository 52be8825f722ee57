/** What the reader has chosen, shared by all views of the page. */

type Listener = () => void;

export const mostSelected = 4;

export class Store {
  /** Ids side by side, in the order in which they were chosen. */
  private chosen: string[] = [];
  private rows: Set<number> | null = null;
  private filters = new Map<string, Set<number> | null>();
  private readonly onSelection: Listener[] = [];
  private readonly onFilter: Listener[] = [];

  get selected(): readonly string[] {
    return this.chosen;
  }

  isSelected(id: string): boolean {
    return this.chosen.includes(id);
  }

  /** Chooses a design or lets it go; of too many the oldest goes, but not the first. */
  toggle(id: string): void {
    if (this.isSelected(id)) this.chosen = this.chosen.filter((one) => one !== id);
    else {
      if (this.chosen.length === mostSelected) this.chosen.splice(1, 1);
      this.chosen.push(id);
    }
    this.onSelection.forEach((tell) => tell());
  }

  select(ids: string[]): void {
    this.start(ids);
    this.onSelection.forEach((tell) => tell());
  }

  /** The same before anything is shown. */
  start(ids: string[]): void {
    this.chosen = ids.slice(0, mostSelected);
  }

  /** Sets what one view lets through; null for everything. What all let through is shown. */
  filter(view: string, rows: Set<number> | null): void {
    this.filters.set(view, rows);
    const active = [...this.filters.values()].filter((set): set is Set<number> => set !== null);
    if (active.length === 0) this.rows = null;
    else {
      const [first, ...others] = active.sort((a, b) => a.size - b.size);
      this.rows = new Set([...first!].filter((row) => others.every((set) => set.has(row))));
    }
    this.onFilter.forEach((tell) => tell());
  }

  /** Whether a row (its number) passes all filters. */
  passes(row: number): boolean {
    return this.rows === null || this.rows.has(row);
  }

  get filtered(): boolean {
    return this.rows !== null;
  }

  selectionChanged(listener: Listener): void {
    this.onSelection.push(listener);
  }

  filterChanged(listener: Listener): void {
    this.onFilter.push(listener);
  }
}
