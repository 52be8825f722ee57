import assert from 'node:assert/strict';
import { test } from 'node:test';
import { deflateSync } from 'node:zlib';
import { column, readSeries, valueAt } from '../src/series';
import { allColumns, firstPanels, panels } from '../src/panels';

function encode(columns: string[], rows: number[][]): Uint8Array {
  const planes: number[] = [];
  columns.forEach((_, c) => {
    const raw = new Uint8Array(Float32Array.from(rows.map((row) => row[c]!)).buffer);
    for (let plane = 0; plane < 4; ++plane) for (let r = 0; r < rows.length; ++r) planes.push(raw[4 * r + plane]!);
  });
  const header = Buffer.from(JSON.stringify({ columns, rows: rows.length }));
  const size = Buffer.alloc(4);
  size.writeUInt32LE(header.length);
  return Buffer.concat([size, header, deflateSync(Uint8Array.from(planes))]);
}

test('series come back as single-precision numbers', async () => {
  const rows = [
    [0, 1.5, NaN],
    [0.5, -3e7, 2],
    [1, 0.1, 4],
  ];
  const series = await readSeries(encode(['time_s', 'a_m', 'b_pa'], rows));
  assert.deepEqual(series.columns, ['time_s', 'a_m', 'b_pa']);
  assert.deepEqual([...column(series, 'a_m')!], [1.5, -3e7, Math.fround(0.1)]);
  assert.ok(Number.isNaN(column(series, 'b_pa')![0]));
  assert.equal(column(series, 'none'), null);
  assert.equal(valueAt(series, column(series, 'b_pa')!, 0.75), 3);
  assert.equal(valueAt(series, column(series, 'a_m')!, 0), 1.5);
  assert.ok(Number.isNaN(valueAt(series, column(series, 'a_m')!, 2)));
});

test('series that are cut off are refused', async () => {
  const bytes = encode(['time_s'], [[0], [1]]);
  await assert.rejects(readSeries(bytes.subarray(0, bytes.length - 2)));
});

test('columns of several barriers share a panel', () => {
  const all = panels(['time_s', 'x_m', 'barrier_1_force_x_n_per_m', 'barrier_2_force_x_n_per_m', 'barrier_1_retention_efficiency']);
  assert.deepEqual(all.map((one) => one.columns.length), [1, 2, 1]);
  assert.deepEqual(firstPanels(all), ['retention_efficiency', 'force_x_n_per_m', 'x_m']);
});

test('runs of one and of two barriers show both barriers', () => {
  const one = ['time_s', 'barrier_1_force_x_n_per_m'];
  const two = ['time_s', 'barrier_1_force_x_n_per_m', 'barrier_2_force_x_n_per_m'];
  assert.deepEqual(panels(allColumns([one, two])), [{ title: 'force_x_n_per_m', columns: two.slice(1) }]);
  assert.deepEqual(panels(allColumns([one])), [{ title: 'force_x_n_per_m', columns: one.slice(1) }]);
});
