/** How to check it: commands, program, definitions, licences. */
import type { Common } from './data';
import { h, section } from './dom';
import { programText } from './format';

export function checkSection(page: Common): HTMLElement {
  const by = page.simulated_by;
  const defined = Object.entries(page.keys).filter(([, info]) => info.definition);
  const licences = document.getElementById('page-licences')?.textContent ?? '';
  const rows: [string, string][] = [
    ['Simulated by', by ? programText(by) : ''],
    ['Physics', by?.physics !== undefined ? String(by.physics) : ''],
    ['Compiler', by?.compiler ?? ''],
    ['Hash of the input', page.hash],
    ['Page written', `${page.date} by ${programText(page.program)}`],
  ];
  return section(
    'check',
    'How do I check it?',
    h('p', {}, 'The same file gives the same numbers, to the bit. These commands repeat what is shown here.'),
    h('dl', { class: 'commands' }, ...page.commands.flatMap((one) => [h('dt', {}, one.what), h('dd', {}, h('code', {}, one.command))])),
    h('table', { class: 'facts' }, h('caption', {}, 'Where it comes from'), h('tbody', {}, ...rows.filter(([, words]) => words).map(([name, words]) => h('tr', {}, h('th', { scope: 'row' }, name), h('td', {}, words))))),
    defined.length > 0 &&
      h('details', {}, h('summary', {}, 'What each metric is'), h('dl', { class: 'definitions' }, ...defined.flatMap(([, info]) => [h('dt', {}, info.unit ? `${info.words} [${info.unit}]` : info.words), h('dd', {}, info.definition!)]))),
    h('details', { id: 'licences' }, h('summary', {}, 'Licences of what this page is made of'), h('pre', { tabindex: 0 }, licences)),
  );
}
