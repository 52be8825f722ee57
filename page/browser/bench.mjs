// Times of the page in headless Chromium: node browser/bench.mjs. Prints a table; bench/page reads it.
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { simulationPage, studyPage } from './fixture.mjs';
import { open } from './open.mjs';

const folder = mkdtempSync(join(tmpdir(), 'parapet-page-'));
const rows = [];
const median = (list) => [...list].sort((a, b) => a - b)[Math.floor(list.length / 2)];

async function interactive(browser, name, html, target) {
  const file = join(folder, `${name}.html`);
  writeFileSync(file, html);
  const times = [];
  for (let k = 0; k < 5; ++k) {
    const page = await browser.newPage();
    await page.goto(pathToFileURL(file).href, { waitUntil: 'commit' });
    // Ready: everything is built, and a click has been answered.
    await page.waitForFunction(() => document.documentElement.dataset.ready === 'true', null, { polling: 10 });
    times.push(
      await page.evaluate(
        () => new Promise((done) => requestAnimationFrame(() => setTimeout(() => done(performance.now())))),
      ),
    );
    await page.close();
  }
  rows.push([`${name}: interactive`, median(times) / 1000, target, 's']);
}

async function frames(browser, particles, target) {
  const file = join(folder, `flow-${particles}.html`);
  writeFileSync(file, simulationPage(particles, 96));
  const page = await browser.newPage({ viewport: { width: 1280, height: 900 } });
  await page.goto(pathToFileURL(file).href);
  await page.waitForFunction(() => document.querySelector('canvas.flow')?.dataset.frame !== undefined);
  const times = await page.evaluate(async () => {
    const canvas = document.querySelector('canvas.flow');
    const scrub = document.querySelector('input.scrub');
    const list = [];
    for (let k = 0; k < 96; ++k) {
      const start = performance.now();
      scrub.value = String(0.02 * k + 0.001);
      scrub.dispatchEvent(new Event('input'));
      while (canvas.dataset.frame !== String(k)) await new Promise((done) => setTimeout(done));
      list.push(performance.now() - start);
      await new Promise((done) => requestAnimationFrame(done));
    }
    return list;
  });
  await page.close();
  rows.push([`${particles} particles: decode and draw a frame, median`, median(times), target, 'ms']);
  rows.push([`${particles} particles: the slowest frame`, Math.max(...times), null, 'ms']);
}

const browser = await open();
try {
  await interactive(browser, '60 designs', studyPage(60), 1);
  await interactive(browser, '5000 designs', studyPage(5000), 3);
  await frames(browser, 3000, 8);
  await frames(browser, 60000, 33);
} finally {
  await browser.close();
  rmSync(folder, { recursive: true });
}
for (const [what, value, target, unit] of rows) {
  const limit = target === null ? '' : `target <= ${target} ${unit}`;
  console.log(`${what.padEnd(58)} ${value.toFixed(2).padStart(9)} ${unit}  ${limit}`);
}
if (process.argv.includes('--strict') && rows.some(([, value, target]) => target !== null && value > target)) process.exitCode = 1;
