import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { StudyPage } from '../src/data';
import { axisValue, bestRows, DesignTable } from '../src/designs';
import { Keys } from '../src/format';
import { Store } from '../src/store';
import { splat, discRows, type ColorScale } from '../src/splat';
import { viridis } from '../src/colors';

test('four designs at most; the first stays', () => {
  const store = new Store();
  for (const id of ['a', 'b', 'c', 'd', 'e']) store.toggle(id);
  assert.deepEqual(store.selected, ['a', 'c', 'd', 'e']);
  store.toggle('a');
  assert.deepEqual(store.selected, ['c', 'd', 'e']);
});

test('filters of several views cut each other', () => {
  const store = new Store();
  let told = 0;
  store.filterChanged(() => ++told);
  assert.ok(store.passes(7) && !store.filtered);
  store.filter('axes', new Set([1, 2, 3]));
  store.filter('table', new Set([2, 3, 4]));
  assert.deepEqual([1, 2, 3, 4].filter((row) => store.passes(row)), [2, 3]);
  store.filter('axes', null);
  assert.deepEqual([1, 2, 3, 4].filter((row) => store.passes(row)), [2, 3, 4]);
  store.filter('table', null);
  assert.ok(!store.filtered);
  assert.equal(told, 4);
});

test('designs are told apart by how they ended, and read by option', () => {
  const page = {
    keys: {},
    variables: [{ name: 'plate', options: ['none', 'steel'] }],
    objectives: [{ name: 'r', goal: 'maximize' }],
    finest_spacing_m: 0.005,
    designs: {
      id: ['1', '2', '3', '4', '5', '6'],
      status: ['ok', 'ok', 'ok', 'ok', 'failed', 'ok'],
      spacing_m: [0.005, 0.005, 0.005, 0.01, 0.005, 0.005],
      feasible: [true, true, false, true, false, true],
      front: [true, false, false, false, false, false],
      warnings: [[], [], [], [], [], ['w']],
      variables: { plate: ['steel', 'none', null, 'none', 'steel', 'steel'] },
      objectives: { r: [0.9, 0.8, 0.95, 0.7, null, 0.85] },
      constraints: {},
      metrics: {},
    },
  } as unknown as StudyPage;
  const table = new DesignTable(page, new Keys(page));
  assert.deepEqual(table.kind, ['front', 'feasible', 'infeasible', 'coarse', 'failed', 'warned']);
  const plate = table.find('variable:plate')!;
  assert.deepEqual([0, 1, 2].map((row) => axisValue(plate, row)), [1, 0, null]);
  const r = table.find('objective:r')!;
  assert.deepEqual([...bestRows(r, 0.5, () => true)].sort(), [0, 2, 5]);
});

test('a particle colours the pixels of its disc, and none outside the picture', () => {
  const width = 9;
  const pixels = new Uint32Array(width * 9);
  const scale: ColorScale = { table: new Uint32Array(256).fill(7), first: 0, step: 1, least: 0, greatest: 1 };
  const place = { x0: 0, xx: 1, xz: 0, y0: 0, yx: 0, yz: 1, radius: 2 };
  const codes = Uint16Array.from([4, 0, 4, 0, 9, 9, 0, 0, 0, 0]); // [field][particle]: at (4, 4) and (0, 0)
  splat(pixels, width, 9, { codes, flags: Uint8Array.from([1, 1]) }, 2, place, 'speed', scale);
  const painted = (x: number, y: number): boolean => pixels[y * width + x] === 7;
  assert.ok(painted(4, 4) && painted(6, 4) && painted(4, 2) && !painted(6, 6) && !painted(7, 4));
  assert.ok(painted(0, 0) && painted(2, 0) && !painted(8, 0));
  assert.deepEqual([...discRows(2)], [0, 1, 2, 1, 0]);
});

test('the colours run from dark blue to yellow and get steadily lighter', () => {
  assert.deepEqual(viridis(0), [0x44, 0x01, 0x54]);
  assert.deepEqual(viridis(1), [0xfd, 0xe7, 0x25]);
  let last = -1;
  for (let k = 0; k <= 50; ++k) {
    const [r, g, b] = viridis(k / 50).map((c) => (c / 255) ** 2.2) as [number, number, number];
    const light = 0.2126 * r + 0.7152 * g + 0.0722 * b;
    assert.ok(light > last);
    last = light;
  }
});
