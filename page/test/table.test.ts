import assert from 'node:assert/strict';
import { test } from 'node:test';
import { csvCell, csvText } from '../src/csv';
import { parseCondition, sortRows, type Column } from '../src/rows';
import { numberText, quantity, withUncertainty } from '../src/format';

const data = [
  { id: '0001', launch: 0.2, stage: 'start' },
  { id: '0002', launch: null, stage: 'search' },
  { id: '0010', launch: 0.05, stage: 'search' },
];
const columns: Column[] = [
  { key: 'id', label: 'Design', value: (row) => data[row]!.id },
  { key: 'launch_length_m', label: 'launch length [m]', value: (row) => data[row]!.launch, numeric: true },
  { key: 'stage', label: 'Stage', value: (row) => data[row]!.stage },
];
const kept = (text: string): number[] => [0, 1, 2].filter(parseCondition(text, columns) ?? (() => true));

test('conditions name a column by key, label or words', () => {
  assert.deepEqual(kept('launch_length_m < 0.1'), [2]);
  assert.deepEqual(kept('launch length >= 0.05'), [0, 2]);
  assert.deepEqual(kept('launch length [m]<0.3, stage=search'), [2]);
  assert.deepEqual(kept('Stage = search and launch_length_m > 1'), []);
  assert.deepEqual(kept('sear'), [1, 2]);
  assert.deepEqual(kept(''), [0, 1, 2]);
});

test('rows without a value come last in both directions', () => {
  assert.deepEqual(sortRows([0, 1, 2], columns[1]!, true), [2, 0, 1]);
  assert.deepEqual(sortRows([0, 1, 2], columns[1]!, false), [0, 2, 1]);
  assert.deepEqual(sortRows([2, 1, 0], columns[0]!, true), [0, 1, 2]);
});

test('CSV keeps what is in a cell and disarms formulas', () => {
  assert.equal(csvCell('a,"b"\n'), '"a,""b""\n"');
  assert.equal(csvCell('=1+1'), "'=1+1");
  assert.equal(csvCell(-0.5), '-0.5');
  assert.equal(csvCell(null), '');
  assert.equal(csvText([['a', 1], ['b', null]]), 'a,1\r\nb,\r\n');
});

test('numbers are rounded as the other reports round them', () => {
  assert.equal(numberText(0.123456), '0.1235');
  assert.equal(numberText(1234.56), '1235');
  assert.equal(numberText(null), '–');
  assert.equal(numberText(0), '0');
  assert.equal(quantity(45, '°'), '45°');
  assert.equal(quantity(2, 'm'), '2\u00a0m');
  assert.equal(withUncertainty(0.68929, 0.0123), '0.689 ± 0.012');
  assert.equal(withUncertainty(1039.498, 120), '1039 ± 120');
});
