/** The page of several studies: one front of all their designs. */
import { checkSection } from './check';
import { palette } from './colors';
import type { StudiesPage } from './data';
import { DesignTable } from './designs';
import { h, section } from './dom';
import { count, numberText, valueElement, type Keys } from './format';
import { FrontView } from './front';
import { distributions, ParallelView } from './parallel';
import { Store } from './store';
import { compareSection, designSection } from './study';
import { view } from './view';

/** A table of the studies: what each has found, and what of it is on the front of all. */
function studiesTable(page: StudiesPage, table: DesignTable, keys: Keys): HTMLElement {
  const head = ['Study', 'Designs', 'Feasible', 'On the joint front', 'Recommended', ...page.objectives.map((one) => keys.label(one.name)), 'Particle spacing'];
  const rows = page.studies.map((one, k) => {
    const row = one.recommended === null ? undefined : table.rowOf.get(one.recommended);
    const mark = h('span', { class: 'swatch', 'aria-hidden': 'true' });
    mark.style.background = palette[k % palette.length]!;
    return h(
      'tr',
      {},
      h('th', { scope: 'row' }, mark, one.label, one.state !== 'done' ? h('span', { class: 'note' }, ` ${one.state || 'state not known'}`) : null),
      h('td', { class: 'number' }, String(one.designs)),
      h('td', { class: 'number' }, String(one.feasible)),
      h('td', { class: 'number' }, String(one.on_joint_front)),
      h('td', {}, one.recommended ?? 'none'),
      ...page.objectives.map((objective) => h('td', { class: 'number' }, valueElement(row === undefined ? null : (page.designs.objectives[objective.name]?.[row] ?? null)))),
      h('td', { class: 'number' }, `${numberText(1000 * one.spacing_m)} mm`),
    );
  });
  return h(
    'div',
    { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': 'The studies' },
    h('table', { class: 'facts' }, h('caption', {}, 'The studies'), h('thead', {}, h('tr', {}, ...head.map((word, k) => h('th', { scope: 'col', class: k > 0 && k !== 4 ? 'number' : '' }, word)))), h('tbody', {}, ...rows)),
  );
}

function headline(page: StudiesPage): string {
  const best = page.studies.filter((one) => one.on_joint_front > 0);
  if (best.length === 0) return 'No design of any study meets every constraint.';
  if (page.objectives.length === 1) return `The best design is of ${best[0]!.label}.`;
  if (best.length === 1) return `Every design on the joint front is of ${best[0]!.label}.`;
  return `The joint front has designs of ${best.map((one) => one.label).join(', ')}.`;
}

export function studiesSections(page: StudiesPage, keys: Keys): HTMLElement[] {
  const table = new DesignTable(page, keys);
  const store = new Store();
  const study = table.find('variable:study');
  const recommended = page.studies.flatMap((one) => (one.recommended === null ? [] : [one.recommended]));
  store.start(view.get('chosen', recommended).filter((id) => table.rowOf.has(id)));
  store.selectionChanged(() => view.set('chosen', [...store.selected]));
  const front = new FrontView(table, keys, store, {}, study);
  const parallel = new ParallelView(table, store, study);
  return [
    section(
      'answer',
      'Which study has the better designs?',
      h(
        'div',
        { class: `verdict ${page.notes.length > 0 ? 'warn' : 'good'}` },
        h('p', { class: 'headline' }, headline(page)),
        h('p', {}, `${count(table.rows, 'design')} of ${page.studies.length} studies, compared by ${page.objectives.map((one) => keys.words(one.name)).join(', ')}. Each design keeps the limits of its own study.`),
        ...page.notes.map((words) => h('p', {}, h('span', { class: 'badge warn' }, 'beware'), ` ${words}`)),
      ),
      studiesTable(page, table, keys),
    ),
    section(
      'else',
      'The joint front',
      h('p', {}, 'A colour is a study; diamonds are on the front of all studies together. Click a design to compare it.'),
      front.element,
      h('h3', {}, 'Parallel coordinates: drag along an axis'),
      parallel.element,
      h('h3', {}, 'Where the variables lie (filled: of the designs that pass the filters)'),
      distributions(table, keys, store),
    ),
    designSection(table, keys, store),
    compareSection(table, keys, store),
    checkSection(page),
  ];
}
