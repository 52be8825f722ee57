/** The page of the validation: scorecard, filter by case and verdict, figures. */
import { checkSection } from './check';
import type { Measure, ValidationPage } from './data';
import { h, section, select } from './dom';
import { numberText, quantity, valueElement } from './format';
import { Table, type Column } from './table';

function limitText(one: Measure): string {
  const unit = one.unit ?? '';
  if (one.lower !== undefined && one.upper !== undefined) return `${numberText(one.lower)} to ${quantity(one.upper, unit)}`;
  if (one.upper !== undefined) return `at most ${quantity(one.upper, unit)}`;
  if (one.lower !== undefined) return `at least ${quantity(one.lower, unit)}`;
  return '';
}

export function validationSections(page: ValidationPage): HTMLElement[] {
  const measures = page.cases.flatMap((one) => one.measures.map((measure) => ({ ...measure, case: one.case, title: one.title })));
  const tally = (word: string): number => measures.filter((one) => one.verdict === word).length;
  let chosenCase = '';
  let chosenVerdict = '';
  const columns: Column[] = [
    { key: 'case', label: 'Case', value: (k) => measures[k]!.title },
    { key: 'what', label: 'Measured', value: (k) => measures[k]!.what },
    { key: 'value', label: 'Value', numeric: true, value: (k) => measures[k]!.value, show: (k) => valueElement(measures[k]!.value, quantity(measures[k]!.value, measures[k]!.unit ?? '')) },
    { key: 'limit', label: 'Limit', value: (k) => limitText(measures[k]!) },
    { key: 'verdict', label: 'Verdict', value: (k) => measures[k]!.verdict, show: (k) => h('span', { class: `badge ${measures[k]!.verdict === 'met' ? 'good' : measures[k]!.verdict === 'missed' ? 'bad' : ''}` }, measures[k]!.verdict) },
    { key: 'reason', label: 'Reason for the limit', value: (k) => measures[k]!.reason ?? '' },
    { key: 'explanation', label: 'Why it is missed', value: (k) => (measures[k]!.verdict === 'missed' ? (measures[k]!.explanation ?? '') : '') },
  ];
  const table = new Table({
    name: 'validation',
    caption: 'Every measured quantity beside its limit',
    hint: 'text, or conditions: verdict = missed, value > 1',
    columns,
    rows: measures.length,
    passes: (k) => (chosenCase === '' || measures[k]!.case === chosenCase) && (chosenVerdict === '' || measures[k]!.verdict === chosenVerdict),
  });
  const figures = h('div', { class: 'figures' });
  const showFigures = (): void => {
    figures.replaceChildren(
      ...page.figures
        .filter((one) => chosenCase === '' || one.case === chosenCase)
        .map((one) => {
          const data = document.getElementById(one.block)?.textContent?.trim() ?? '';
          return h('figure', {}, h('img', { src: `data:image/png;base64,${data}`, alt: `Figure ${one.file}`, loading: 'lazy' }), h('figcaption', {}, one.file));
        }),
    );
  };
  showFigures();
  const update = (): void => {
    table.update();
    showFigures();
  };
  const every = { value: '', text: 'all' };
  const verdicts = [...new Set(measures.map((one) => one.verdict))];
  const failures = page.cases.filter((one) => one.failure);
  return [
    section(
      'answer',
      'How far can the solver be trusted?',
      h(
        'div',
        { class: `verdict ${tally('missed') + failures.length > 0 ? 'warn' : 'good'}` },
        h('p', { class: 'headline' }, `${tally('met')} of ${tally('met') + tally('missed')} limits are met.`),
        h('p', {}, `${page.cases.length} cases with exact, measured or published answers; ${tally('measured')} further numbers are reported without a limit.`),
        ...failures.map((one) => h('p', {}, `${one.title} failed: ${one.failure}`)),
      ),
      h(
        'div',
        { class: 'row' },
        select('Case', [every, ...page.cases.map((one) => ({ value: one.case, text: one.title }))], '', (value) => {
          chosenCase = value;
          update();
        }),
        select('Verdict', [every, ...verdicts.map((one) => ({ value: one, text: one }))], '', (value) => {
          chosenVerdict = value;
          update();
        }),
      ),
      table.element,
    ),
    section('figures', 'Figures', page.figures.length > 0 ? figures : h('p', { class: 'note' }, 'There are no figures in the folder.')),
    checkSection(page),
  ];
}
