/** A page that is served while a study runs: it says what is new and offers to show it. */
import { button, h } from './dom';
import { view } from './view';

/** How long to wait before the page is made anew, after it took so long to come [ms]: it must be
 * readable most of the time, however fast designs end and however slow the machine is. */
export function patience(loading: number): number {
  return Math.max(5000, 5 * loading);
}

/** @param state of the study: "running", "done"; empty where the page is of none */
export function liveBar(state: string): HTMLElement {
  const status = h('span', { role: 'status' }, state === 'running' ? 'Live: waiting for the next design.' : 'Live: nothing new yet.');
  const made = performance.now();
  let planned = false;
  const show = (): void => {
    sessionStorage.setItem('view', view.text());
    location.reload();
  };
  const reload = button('Show what is new', show);
  reload.hidden = true;
  const follow = h('input', { type: 'checkbox' });
  const plan = (): void => {
    if (planned || !follow.checked || reload.hidden) return;
    planned = true;
    setTimeout(() => {
      planned = false;
      if (follow.checked) show();
    }, Math.max(0, patience(made) - (performance.now() - made)));
  };
  follow.checked = sessionStorage.getItem('follow') === 'yes';
  follow.addEventListener('change', () => {
    sessionStorage.setItem('follow', follow.checked ? 'yes' : 'no');
    plan();
  });
  const events = new EventSource('events');
  events.addEventListener('changed', (event) => {
    const data = JSON.parse((event as MessageEvent<string>).data) as { designs: number; state: string };
    status.textContent = `${data.designs} designs, ${data.state}. There is something new.`;
    reload.hidden = false;
    plan();
  });
  events.addEventListener('error', () => (status.textContent = 'The program that serves this page has ended.'));
  return h('div', { class: 'live row' }, status, reload, h('label', { class: 'tick' }, follow, ' follow'));
}
