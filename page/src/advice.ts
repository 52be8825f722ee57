/** Page one: what to build, what to expect of it, and how sure that is. */
import type { StudyPage } from './data';
import type { ConstraintResult, DesignReport, PageOne, PageOneLine } from './recommendation';
import { h, type Child } from './dom';
import { drawing } from './drawing';
import { numberText, quantity, valueElement, withUncertainty, type Keys } from './format';
import { titleBlock } from './runs';

function variablesTable(design: DesignReport, keys: Keys): HTMLElement {
  return h(
    'table',
    { class: 'facts' },
    h('caption', {}, 'The arrangement'),
    h('tbody', {},
      ...design.variables.map((one) =>
        h(
          'tr',
          {},
          h('th', { scope: 'row' }, keys.words(one.name)),
          h('td', { class: 'number' }, one.option !== undefined ? one.option : valueElement(one.value, keys.quantity(one.name, one.value))),
          h('td', {}, one.at_bound ? h('span', { class: 'badge warn' }, `at its ${one.at_bound} bound`) : ''),
        ),
      ),
    ),
  );
}

/** What a repeat of the built design would give: objectives, limits, design loads. */
function performanceTable(lines: PageOneLine[], caption: string): HTMLElement {
  return h(
    'table',
    { class: 'facts' },
    h('caption', {}, caption),
    h('thead', {}, h('tr', {}, h('th', { scope: 'col' }, 'Quantity'), h('th', { scope: 'col', class: 'number' }, 'A repeat gives (95 %)'), h('th', { scope: 'col' }, 'Asked'), h('th', { scope: 'col', class: 'number' }, 'Holds'))),
    h('tbody', {},
      ...lines.map((one) =>
        h(
          'tr',
          {},
          h('th', { scope: 'row' }, one.label),
          h('td', { class: 'number' }, one.mean === null ? one.text : valueElement(one.mean, one.text)),
          h('td', {}, one.asked),
          h('td', { class: 'number' }, one.probability === null ? '' : shareText(one.probability)),
        ),
      ),
    ),
  );
}

function shareText(share: number): string {
  if (share > 0.999) return 'more than 99.9 %';
  return share < 0.001 ? 'less than 0.1 %' : `${(100 * share).toFixed(share > 0.99 ? 1 : 0)} %`;
}

function limits(one: ConstraintResult, unit: string): string {
  if (one.lower !== null && one.upper !== null) return `${quantity(one.lower, unit)} to ${quantity(one.upper, unit)}`;
  if (one.upper !== null) return `at most ${quantity(one.upper, unit)}`;
  return `at least ${quantity(one.lower, unit)}`;
}

function constraintTable(design: DesignReport, keys: Keys): HTMLElement {
  return h(
    'table',
    { class: 'facts' },
    h('caption', {}, 'Limits and margins'),
    h('thead', {}, h('tr', {}, ...['Limit', 'Asked', 'Value', 'Margin', 'Verdict'].map((word, k) => h('th', { scope: 'col', class: k > 0 && k < 4 ? 'number' : '' }, word)))),
    h('tbody', {},
      ...design.constraints.map((one) => {
        const unit = keys.unit(one.metric ?? one.name);
        const share = one.margin_percent === null ? '' : ` (${numberText(one.margin_percent)} %)`;
        const kind = !one.satisfied ? 'bad' : one.active ? 'warn' : 'good';
        return h(
          'tr',
          {},
          h('th', { scope: 'row', title: one.expression }, `${keys.words(one.name)}${one.statistic ? `, ${one.statistic}` : ''}`),
          h('td', { class: 'number' }, limits(one, unit)),
          h('td', { class: 'number' }, valueElement(one.value, quantity(one.value, unit))),
          h('td', { class: 'number' }, one.margin === null ? '–' : quantity(one.margin, unit) + share),
          h('td', {}, h('span', { class: `badge ${kind}` }, one.satisfied ? (one.active ? 'just met' : 'met') : 'broken')),
        );
      }),
    ),
  );
}

export function metricTable(
  metrics: Record<string, number | null>,
  absent: Record<string, string>,
  keys: Keys,
  uncertainty: Record<string, { expanded_95: number; discretisation: number; scatter: number }> = {},
): HTMLElement {
  const some = Object.keys(uncertainty).length > 0;
  return h(
    'div',
    { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': 'All metrics' },
    h(
      'table',
      { class: 'facts' },
      h('caption', {}, 'All metrics'),
      h('thead', {}, h('tr', {}, h('th', { scope: 'col' }, 'Metric'), h('th', { scope: 'col', class: 'number' }, 'Value'), h('th', { scope: 'col' }, 'Unit'), some && h('th', { scope: 'col', class: 'number' }, 'Uncertainty (95 %)'), h('th', { scope: 'col' }, 'What it is'))),
      h('tbody', {},
        ...Object.entries(metrics).map(([key, value]) => {
          const own = uncertainty[key];
          const text = value !== null && own ? withUncertainty(value, own.expanded_95).split(' ±')[0] : numberText(value);
          return h(
            'tr',
            {},
            h('th', { scope: 'row' }, keys.words(key)),
            h('td', { class: 'number' }, valueElement(value, text)),
            h('td', {}, keys.unit(key)),
            some && h('td', { class: 'number' }, own ? `± ${numberText(own.expanded_95)}` : '–'),
            h('td', { class: 'note' }, value === null ? `none: ${absent[key] ?? 'not defined'}` : (keys.definition(key) ?? '')),
          );
        }),
      ),
    ),
  );
}

/** A table that may be wider than the screen. */
function scroll(table: HTMLElement): HTMLElement {
  return h('div', { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': table.querySelector('caption')?.textContent ?? 'Table' }, table);
}

/** The design to show: the recommended one, else the one that misses least. */
export function shownDesign(page: StudyPage): DesignReport | null {
  return page.recommendation.recommended ?? page.recommendation.least_violating ?? null;
}

const sentence = (words: string): string => words.charAt(0).toUpperCase() + words.slice(1) + (words.endsWith('.') ? '' : '.');

function verdictBox(page: StudyPage, one: PageOne): HTMLElement {
  if (one.instead !== '') {
    return h('div', { class: 'verdict bad' }, h('p', { class: 'headline' }, one.title), h('p', {}, one.instead));
  }
  const kind = { confirmed: 'good', refuted: 'bad', narrow: 'warn', untested: 'warn', none: 'bad' }[one.verdict];
  return h(
    'div',
    { class: `verdict ${kind}` },
    h('p', { class: 'headline' }, page.state === 'running' ? `Best so far: design ${one.design}.` : one.verdict === 'refuted' ? `Design ${one.design}: do not build it yet.` : `Build design ${one.design}.`),
    page.state === 'running' ? h('p', {}, 'The study still runs: wait for its end before you build.') : page.state === 'interrupted' ? h('p', {}, 'The study was interrupted: the same command goes on with it.') : null,
    h('p', {}, `${sentence(one.arrangement)}`),
    h('p', {}, sentence(one.verdict_words)),
    ...[one.probability_words, one.chosen, one.ties, one.bounds, one.grid].filter((words) => words !== '').map((words) => h('p', {}, sentence(words))),
  );
}

/** The parts that recommendation.md has on page one, from the same structure. */
export function adviceSheet(page: StudyPage, keys: Keys): Child[] {
  const design = shownDesign(page);
  const one = page.recommendation.page_one;
  if (!design || !one) return [h('p', { class: 'verdict warn' }, page.live ? 'No design has ended yet.' : 'No design ended well, so there is nothing to recommend.')];
  const scene = page.runs[design.id]?.scene;
  const lines = [...one.performance, ...one.limits, ...one.loads];
  return [
    h(
      'div',
      { class: 'sheet-grid' },
      h('div', {}, verdictBox(page, one), variablesTable(design, keys)),
      scene ? h('figure', { class: 'sheet-drawing' }, drawing(scene, titleBlock(page, `Design ${design.id}`))) : null,
    ),
    lines.length > 0 && scroll(performanceTable(lines, 'What a repeat of it would give')),
  ];
}

export function surenessParts(page: StudyPage, keys: Keys): Child[] {
  const { confirmation, caveats, sensitivity, improvement } = page.recommendation;
  const design = shownDesign(page);
  const parts: Child[] = [];
  if (design && design.constraints.length > 0) parts.push(scroll(constraintTable(design, keys)));
  if (confirmation && confirmation.runs.length > 0) {
    parts.push(
      h('div', { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': 'The design simulated again' },
        h('table', { class: 'facts' },
          h('caption', {}, 'The design and near-equal ones, simulated again'),
          h('thead', {}, h('tr', {}, h('th', { scope: 'col' }, 'Run'), h('th', { scope: 'col', class: 'number' }, 'Spacing'), ...page.objectives.map((one) => h('th', { scope: 'col', class: 'number' }, keys.label(one.name))), h('th', { scope: 'col' }, 'Limits'))),
          h('tbody', {},
            ...confirmation.runs.map((run) =>
              h('tr', {},
                h('th', { scope: 'row' }, run.id),
                h('td', { class: 'number' }, `${numberText(1000 * run.spacing_m)} mm`),
                ...run.objectives.map((value) => h('td', { class: 'number' }, valueElement(value))),
                h('td', {}, h('span', { class: `badge ${run.feasible && run.worse.length === 0 ? 'good' : 'bad'}` }, run.ok ? (run.feasible ? (run.worse.length > 0 ? `worse than predicted: ${run.worse.map((name) => keys.words(name)).join(', ')}` : 'met') : `breaks ${run.violated.map((name) => keys.words(name)).join(', ')}`) : `failed: ${run.reason}`)),
              ),
            ),
          ),
        ),
      ),
    );
  } else if (design) {
    parts.push(h('p', { class: 'note' }, 'Nothing was simulated again. ', h('code', {}, page.commands.find((one) => one.what.includes('recommend'))?.command ?? 'parapet recommend DIR'), ' does it.'));
  }
  for (const one of confirmation?.refuted ?? []) {
    parts.push(h('p', {}, `Design ${one.id} comes first by the rule, but it did not hold: ${[...one.violated, ...one.worse.map((name) => `${name} worse than predicted`)].map((name) => keys.words(name)).join(', ') || 'a simulation failed'}.`));
  }
  const quality = (sensitivity?.metrics ?? []).filter((one) => one.q_squared !== null);
  if (quality.length > 0) {
    parts.push(h('p', {}, 'The surrogates, each design left out in turn, explain ', quality.map((one) => `${one.name === one.metric ? keys.words(one.metric) : keys.modelled(one.name, one.metric)}: ${numberText(100 * one.q_squared!)} %`).join('; '), ' of the variation.'));
  }
  if (improvement && !improvement.same_design) {
    parts.push(h('p', {}, `Over the best start (${improvement.start_id}): `, improvement.objectives.map((one) => `${keys.words(one.name)} ${keys.quantity(one.name, one.start)} → ${keys.quantity(one.name, one.best)}`).join('; '), '.'));
  }
  if (caveats && caveats.length > 0) {
    parts.push(h('h3', {}, 'What to bear in mind'), h('ul', {}, ...caveats.map((words) => h('li', {}, words))));
  }
  if (design) {
    parts.push(h('details', {}, h('summary', {}, `All metrics of design ${design.id}`), metricTable(design.metrics, design.metrics_absent, keys)));
  }
  return parts;
}
