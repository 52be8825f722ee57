/** Page one: what to build, what to expect of it, and how sure that is. */
import type { ConstraintResult, DesignReport, StudyPage } from './data';
import { h, type Child } from './dom';
import { drawing } from './drawing';
import { count, numberText, quantity, valueElement, withUncertainty, type Keys } from './format';
import { titleBlock } from './runs';

const verdictWords: Record<string, string> = {
  confirmed: 'Confirmed: it met every constraint when it was simulated again.',
  refuted: 'Refuted: it did not hold when it was simulated again.',
  none: 'Not confirmed: it was not simulated again.',
};

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

function performanceTable(page: StudyPage, design: DesignReport, keys: Keys): HTMLElement {
  const spread = page.recommendation.confirmation?.spread ?? [];
  const rows = design.objectives.map((one) => {
    const estimate = design.estimates?.find((other) => other.name === one.name);
    const again = spread.find((other) => other.name === one.name);
    const interval =
      estimate && estimate.lower_95 !== null && estimate.upper_95 !== null
        ? `${numberText(estimate.lower_95)} to ${numberText(estimate.upper_95)}`
        : one.expression
          ? 'exact'
          : '–';
    const repeats = again ? `${numberText(again.least)} to ${numberText(again.greatest)} (${count(again.runs, 'run')})` : '–';
    return h(
      'tr',
      {},
      h('th', { scope: 'row' }, `${keys.words(one.name)} (${one.goal === 'maximize' ? 'more' : 'less'} is better)`),
      h('td', { class: 'number' }, valueElement(one.value, keys.quantity(one.name, one.value)), one.absent ? h('span', { class: 'note' }, ' stands for: none') : null),
      h('td', { class: 'number' }, interval),
      h('td', { class: 'number' }, repeats),
    );
  });
  return h(
    'table',
    { class: 'facts' },
    h('caption', {}, 'Expected performance'),
    h('thead', {}, h('tr', {}, h('th', { scope: 'col' }, 'Objective'), h('th', { scope: 'col', class: 'number' }, 'Simulated'), h('th', { scope: 'col', class: 'number' }, 'Surrogate, 95 %'), h('th', { scope: 'col', class: 'number' }, 'When repeated'))),
    h('tbody', {}, ...rows),
  );
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

function verdictBox(page: StudyPage, design: DesignReport, keys: Keys): HTMLElement {
  const { recommendation } = page;
  if (!recommendation.recommended) {
    return h(
      'div',
      { class: 'verdict bad' },
      h('p', { class: 'headline' }, 'No design meets every constraint.'),
      h('p', {}, `Design ${design.id} comes nearest. Do not build it as it is.`),
    );
  }
  const verdict = recommendation.confirmation?.verdict ?? 'none';
  const kind = verdict === 'confirmed' ? 'good' : verdict === 'refuted' ? 'bad' : 'warn';
  const probability = design.probability_feasible;
  const first = design.objectives.map((one) => `${keys.words(one.name)} ${keys.quantity(one.name, one.value)}`).join(', ');
  return h(
    'div',
    { class: `verdict ${kind}` },
    h('p', { class: 'headline' }, page.state === 'running' ? `Best so far: design ${design.id}.` : `Build design ${design.id}.`),
    page.state === 'running' ? h('p', {}, 'The study still runs: wait for its end before you build.') : page.state === 'interrupted' ? h('p', {}, 'The study was interrupted: the same command goes on with it.') : null,
    h('p', {}, `${first}.`),
    h('p', {}, verdictWords[verdict] ?? verdict),
    probability !== null && probability !== undefined &&
      h('p', {}, 'Probability that it meets every constraint, by the surrogate: ', h('strong', {}, probability > 0.999 ? 'more than 99.9 %' : `${numberText(100 * probability)} %`), '.'),
    h('p', { class: 'note' }, recommendation.rule?.words ?? ''),
  );
}

export function adviceSheet(page: StudyPage, keys: Keys): Child[] {
  const design = shownDesign(page);
  if (!design) return [h('p', { class: 'verdict warn' }, page.live ? 'No design has ended yet.' : 'No design ended well, so there is nothing to recommend.')];
  const scene = page.runs[design.id]?.scene;
  return [
    h(
      'div',
      { class: 'sheet-grid' },
      h('div', {}, verdictBox(page, design, keys), variablesTable(design, keys)),
      scene ? h('figure', { class: 'sheet-drawing' }, drawing(scene, titleBlock(page, `Design ${design.id}`))) : null,
    ),
    scroll(performanceTable(page, design, keys)),
    design.constraints.length > 0 && scroll(constraintTable(design, keys)),
  ];
}

export function surenessParts(page: StudyPage, keys: Keys): Child[] {
  const { confirmation, caveats, sensitivity, improvement } = page.recommendation;
  const design = shownDesign(page);
  const parts: Child[] = [];
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
                h('td', {}, h('span', { class: `badge ${run.feasible ? 'good' : 'bad'}` }, run.ok ? (run.feasible ? 'met' : `breaks ${run.violated.map((name) => keys.words(name)).join(', ')}`) : `failed: ${run.reason}`)),
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
    parts.push(h('p', {}, `Design ${one.id} comes first by the rule, but it did not hold: ${one.violated.map((name) => keys.words(name)).join(', ') || 'a simulation failed'}.`));
  }
  const quality = (sensitivity?.metrics ?? []).filter((one) => one.q_squared !== null);
  if (quality.length > 0) {
    parts.push(h('p', {}, 'The surrogates, each design left out in turn, explain ', quality.map((one) => `${keys.words(one.metric)}: ${numberText(100 * one.q_squared!)} %`).join('; '), ' of the variation.'));
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
