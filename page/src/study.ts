/** The page of a study. */
import { adviceSheet, shownDesign, surenessParts } from './advice';
import { checkSection } from './check';
import type { StudyPage } from './data';
import { DesignTable, kinds } from './designs';
import { button, checkbox, h, section } from './dom';
import { convergenceView, effectsView } from './effects';
import { count, numberText, valueElement, type Keys } from './format';
import { FrontView } from './front';
import { distributions, ParallelView } from './parallel';
import { compareRuns } from './runs';
import { mostSelected, Store } from './store';
import { Table, type Column } from './table';
import { view } from './view';

function designColumns(table: DesignTable, keys: Keys, store: Store): Column[] {
  const { designs } = table.page;
  const columns: Column[] = [
    {
      key: 'id',
      label: 'Design',
      value: (row) => designs.id[row]!,
      show: (row) => {
        const id = designs.id[row]!;
        const label = checkbox(id, store.isSelected(id), () => store.toggle(id));
        label.querySelector('input')!.setAttribute('aria-label', `Compare design ${id}`);
        return label;
      },
    },
    {
      key: 'kind',
      label: 'Kind',
      value: (row) => kinds.find((one) => one.kind === table.kind[row])!.short,
      show: (row) => {
        const reason = designs.reason[row];
        const warnings = designs.warnings[row] ?? [];
        const title = [reason, ...warnings].filter(Boolean).join('; ');
        return h('span', { class: `kind ${table.kind[row]}`, title: title || undefined }, kinds.find((one) => one.kind === table.kind[row])!.short);
      },
    },
  ];
  for (const one of table.quantities) {
    if (one.group === 'metric') continue;
    columns.push({
      key: one.name,
      label: one.label,
      title: `${one.group}${keys.definition(one.name) ? `: ${keys.definition(one.name)}` : ''}`,
      numeric: !one.options,
      value: (row) => one.values[row] ?? null,
      show: (row) => {
        const value = one.values[row];
        return typeof value === 'string' ? value : valueElement(value);
      },
    });
  }
  columns.push(
    {
      key: 'warnings',
      label: 'Warnings',
      numeric: true,
      value: (row) => (designs.warnings[row] ?? []).length,
      show: (row) => {
        const warnings = designs.warnings[row] ?? [];
        return h('span', { title: warnings.join('; ') || undefined }, String(warnings.length));
      },
    },
    { key: 'spacing_m', label: 'Spacing [m]', numeric: true, value: (row) => designs.spacing_m[row]! },
    { key: 'stage', label: 'Stage', value: (row) => designs.stage[row]! },
  );
  return columns;
}

/** A condition on the first variable that has a number, as an example. */
function exampleCondition(table: DesignTable): string {
  const one = table.quantities.find((quantity) => !quantity.options);
  return one ? `${one.label.replace(/ \[.*/, '')} < ${numberText(one.values.find((value): value is number => typeof value === 'number'))}` : 'stage = search';
}

export function designSection(table: DesignTable, keys: Keys, store: Store): HTMLElement {
  const base = designColumns(table, keys, store);
  const extra = table.quantities.filter((one) => one.group === 'metric');
  const place = h('div');
  const chosen = new Set<string>();
  const make = (): void => {
    const columns = [
      ...base,
      ...extra
        .filter((one) => chosen.has(one.key))
        .map((one): Column => ({ key: one.name, label: one.label, title: keys.definition(one.name), numeric: true, value: (row) => one.values[row] ?? null, show: (row) => valueElement(one.values[row] as number | null) })),
    ];
    const view = new Table({
      name: table.page.name.replace(/[^\w.-]+/g, '_'),
      caption: 'Every design that was evaluated',
      hint: `text, or conditions: kind = feasible, ${exampleCondition(table)}`,
      columns,
      rows: table.rows,
      passes: (row) => store.passes(row),
      rowClass: (row) => (store.isSelected(table.page.designs.id[row]!) ? 'selected' : ''),
      onFilter: (rows) => store.filter('table', rows),
    });
    current = view;
    place.replaceChildren(view.element);
  };
  let current: Table | null = null;
  make();
  store.selectionChanged(() => current?.update());
  store.filterChanged(() => current?.update());
  return section(
    'designs',
    'All designs',
    place,
    extra.length > 0 &&
      h('details', {}, h('summary', {}, 'Further columns'), h('div', { class: 'ticks' }, ...extra.map((one) => checkbox(one.label, false, (on) => {
        if (on) chosen.add(one.key);
        else chosen.delete(one.key);
        make();
      })))),
  );
}

export function compareSection(table: DesignTable, keys: Keys, store: Store): HTMLElement {
  const place = h('div');
  const list = h('div', { class: 'row chosen' });
  let last = '';
  const update = (): void => {
    const names = store.selected;
    if (names.join() === last) return;
    last = names.join();
    list.replaceChildren(...names.map((id) => button(`${id} ✕`, () => store.toggle(id), { title: `Leave design ${id} out` })));
    place.replaceChildren(
      names.length === 0
        ? h('p', { class: 'note' }, 'Choose designs in the table or in the front.')
        : compareRuns(table.page, keys, names, (id) => {
            const row = table.rowOf.get(id)!;
            const warnings = table.page.designs.warnings[row] ?? [];
            return h('span', {}, `Design ${id}`, h('span', { class: 'note' }, ` ${table.words(row, keys)}${warnings.length > 0 ? `. Warnings: ${warnings.join('; ')}` : ''}`));
          }, true),
    );
  };
  store.selectionChanged(update);
  update();
  return section('flow', 'What does the flow look like?', h('p', {}, `Up to ${mostSelected} designs side by side, in step. Choose them in the front or in the table.`), list, place);
}

export function studySections(page: StudyPage, keys: Keys): HTMLElement[] {
  const table = new DesignTable(page, keys);
  const store = new Store();
  const start = shownDesign(page)?.id;
  store.start(view.get('chosen', start === undefined ? [] : [start]).filter((id) => table.rowOf.has(id)));
  store.selectionChanged(() => view.set('chosen', [...store.selected]));
  const convergence = convergenceView(page);
  const failed = table.kind.filter((one) => one === 'failed').length;
  const sections = [
    section('build', 'What should I build?', ...adviceSheet(page, keys)),
    section('sure', 'How sure are we?', ...surenessParts(page, keys)),
  ];
  if (table.rows === 0) return [...sections, checkSection(page)];
  const front = new FrontView(table, keys, store, page.recommendation);
  const parallel = new ParallelView(table, store);
  sections.push(
    section(
      'else',
      'What else is possible?',
      h('p', {}, `${count(table.rows, 'design')} were evaluated, ${table.page.designs.front.filter(Boolean).length} of them on the front${failed > 0 ? `, ${failed} failed` : ''}. Click a design to compare it.`),
      h('h3', {}, page.objectives.length > 1 ? 'The front' : 'The designs'),
      front.element,
      h('h3', {}, 'Parallel coordinates: drag along an axis'),
      parallel.element,
      h('h3', {}, 'Where the variables lie (filled: of the designs that pass the filters)'),
      distributions(table, keys, store),
    ),
    designSection(table, keys, store),
    compareSection(table, keys, store),
    section('why', 'What matters?', effectsView(page, keys)),
  );
  if (convergence) sections.push(section('progress', 'Did the search converge?', convergence));
  sections.push(checkSection(page));
  return sections;
}
