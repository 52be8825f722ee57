/** A page that is served while a study runs: it says what is new and offers to show it. */
import { button, h } from './dom';

export function liveBar(): HTMLElement {
  const status = h('span', { role: 'status' }, 'Live: waiting for the next design.');
  const reload = button('Show what is new', () => location.reload());
  reload.hidden = true;
  const follow = h('input', { type: 'checkbox' });
  follow.checked = sessionStorage.getItem('follow') === 'yes';
  follow.addEventListener('change', () => sessionStorage.setItem('follow', follow.checked ? 'yes' : 'no'));
  const events = new EventSource('events');
  events.addEventListener('changed', (event) => {
    const data = JSON.parse((event as MessageEvent<string>).data) as { designs: number; state: string };
    status.textContent = `${data.designs} designs, ${data.state}. There is something new.`;
    reload.hidden = false;
    if (follow.checked) location.reload();
  });
  events.addEventListener('error', () => (status.textContent = 'The program that serves this page has ended.'));
  return h('div', { class: 'live row' }, status, reload, h('label', { class: 'tick' }, follow, ' follow'));
}
