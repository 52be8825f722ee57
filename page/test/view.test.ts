import assert from 'node:assert/strict';
import { test } from 'node:test';
import { View } from '../src/view';

test('a view comes back as it was saved', () => {
  const view = new View('');
  assert.equal(view.get('front.x', 'a'), 'a');
  view.set('front.x', '</script><b>');
  view.set('chosen', ['0001', '0002']);
  view.set('time', 0.5);
  assert.ok(!view.text().includes('<'));
  const again = new View(view.text());
  assert.equal(again.get('front.x', ''), '</script><b>');
  assert.deepEqual(again.get('chosen', [] as string[]), ['0001', '0002']);
  assert.equal(again.get('time', 0), 0.5);
});

test('what is damaged or of another kind is passed over', () => {
  assert.equal(new View('{').get('time', 1), 1);
  assert.equal(new View('null').get('time', 1), 1);
  const view = new View('{"time": "soon", "chosen": "0001", "colour": "magic"}');
  assert.equal(view.get('time', 1), 1);
  assert.deepEqual(view.get('chosen', [] as string[]), []);
  assert.equal(view.choice('colour', ['speed', 'pressure'], 'speed'), 'speed');
});
