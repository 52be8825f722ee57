// The pages that the program wrote, in headless Chromium without a network:
//   node browser/run.mjs DIR [SCREENSHOTS]
// DIR holds the folders study (recommended, with recordings), dual (two barriers, a long description),
// robust (over events), simulation (recorded, with a hostile name), sweep, validation and studies (study
// beside a committed one), each with its report.html.
// See .ci/page.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { studyPage } from './fixture.mjs';
import { open } from './open.mjs';

const folder = resolve(process.env.PAGES ?? process.argv[2] ?? 'pages');
const shots = process.env.SCREENSHOTS;
const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const json = (path) => JSON.parse(readFileSync(join(folder, path), 'utf8'));
const lines = (path) => readFileSync(join(folder, path), 'utf8').trim().split('\n').map((line) => JSON.parse(line));

let browser;
const scratch = mkdtempSync(join(tmpdir(), 'parapet-browser-'));
before(async () => {
  browser = await open();
  if (shots) mkdirSync(shots, { recursive: true });
});
after(async () => {
  await browser.close();
  rmSync(scratch, { recursive: true });
});

/** Opens a page; whatever it asks for beside itself, and every error, is in `wrong`. */
async function visit(file, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, acceptDownloads: true, ...options });
  const page = await context.newPage();
  const wrong = [];
  const address = pathToFileURL(file).href;
  await context.route('**', (route) => {
    const url = route.request().url();
    if (url === address || url.startsWith('data:') || url.startsWith('blob:')) return route.continue();
    wrong.push(`asked for ${url}`);
    return route.abort();
  });
  page.on('console', (message) => {
    if (message.type() === 'error' || message.type() === 'warning') wrong.push(`console: ${message.text()}`);
  });
  page.on('pageerror', (error) => wrong.push(`error: ${error.message}`));
  page.on('dialog', (dialog) => {
    wrong.push(`dialog: ${dialog.message()}`);
    void dialog.dismiss();
  });
  await page.goto(address);
  await page.waitForFunction(() => document.documentElement.dataset.ready === 'true');
  return { page, wrong, close: () => context.close() };
}

/** Scrolls through the page, so that every chart is drawn. */
async function look(page) {
  const height = await page.evaluate(() => document.documentElement.scrollHeight);
  for (let y = 0; y < height; y += 600) {
    await page.evaluate((top) => window.scrollTo(0, top), y);
    await page.waitForTimeout(60);
  }
  await page.evaluate(() => window.scrollTo(0, 0));
}

async function shoot(page, name, options = {}) {
  if (shots) await page.screenshot({ path: join(shots, `${name}.png`), ...options });
}

const values = (page, selector) => page.$$eval(`${selector} data`, (list) => list.map((one) => Number(one.value)));

const kinds = ['study', 'simulation', 'sweep', 'validation', 'studies'];

for (const kind of kinds) {
  for (const scheme of ['light', 'dark']) {
    test(`${kind}, ${scheme}: opens without a network, no errors, axe finds nothing serious`, async () => {
      const { page, wrong, close } = await visit(join(folder, kind, 'report.html'), { colorScheme: scheme });
      await look(page);
      await page.evaluate(axe);
      const { violations } = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ['violations'] }));
      const serious = violations.filter((one) => one.impact === 'serious' || one.impact === 'critical');
      assert.deepEqual(serious.map((one) => `${one.id}: ${one.nodes.slice(0, 3).map((node) => node.html).join(' ')}`), []);
      await shoot(page, `${kind}-${scheme}`, { fullPage: true });
      assert.deepEqual(wrong, []);
      await close();
    });
  }

  test(`${kind}: fits a narrow screen`, async () => {
    const { page, close } = await visit(join(folder, kind, 'report.html'), { viewport: { width: 390, height: 800 } });
    await look(page);
    const [wide, view] = await page.evaluate(() => [document.documentElement.scrollWidth, window.innerWidth]);
    assert.ok(wide <= view + 1, `${wide} pixels wide on a screen of ${view}`);
    // The parts of the page are listed across the screen, and names of axes can be read.
    const nav = await page.$eval('nav', (one) => one.getBoundingClientRect().width);
    assert.ok(nav > 300, `the list of parts is ${nav} pixels wide`);
    for (const [room, axes] of await page.$$eval('.chart.axes', (list) => list.map((one) => [one.clientWidth, Number(getComputedStyle(one).getPropertyValue('--axes'))]))) {
      assert.ok(room >= 80 * axes, `${room} pixels for ${axes - 1} axes`);
    }
    await shoot(page, `${kind}-narrow`, { fullPage: true });
    await close();
  });
}

for (const kind of [...kinds, 'dual', 'robust']) {
  test(`${kind}: prints with page one on A4`, async () => {
    const { page, wrong, close } = await visit(join(folder, kind, 'report.html'));
    await look(page);
    // At the width of the paper nothing is wider: else the browser shrinks everything, drawings too.
    await page.emulateMedia({ media: 'print' });
    await page.setViewportSize({ width: 688, height: 1000 }); // 182 mm
    const wide = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(wide <= 688, `${wide} pixels on 688`);
    for (const width of await page.$$eval('.sheet-drawing .drawing', (list) => list.map((one) => one.getBoundingClientRect().width))) {
      assert.ok(Math.abs(width - (180 / 25.4) * 96) < 1, `a drawing ${width} pixels wide is not 180 mm`);
    }
    const first = await page.evaluate(() => document.querySelector('main section').getBoundingClientRect().bottom + scrollY);
    if (['study', 'dual', 'robust'].includes(kind)) assert.ok(first <= (269 / 25.4) * 96, `page one is ${first} pixels high`); // 297 mm less its margins
    // Nothing is cut off or drawn out: tables have all their columns, flows their proportions.
    for (const [right, what] of await page.$$eval('#build table, #sure table, #designs table, main canvas, main svg', (list) => list.map((one) => [one.getBoundingClientRect().right, one.className]))) {
      assert.ok(right <= 689, `${what} reaches to ${right} of 688 pixels`);
    }
    for (const [drawn, own] of await page.$$eval('canvas.flow', (list) => list.map((one) => [one.clientWidth / one.clientHeight, one.width / one.height]))) {
      assert.ok(Math.abs(drawn / own - 1) < 0.02, `a flow is drawn ${drawn} to 1 instead of ${own}`);
    }
    for (const one of await page.$$('button')) assert.ok(!(await one.isVisible()) || (await one.getAttribute('class')) === 'sort', `a button is printed: ${await one.textContent()}`);
    const pdf = await page.pdf({ preferCSSPageSize: true, printBackground: true });
    const text = pdf.toString('latin1');
    assert.match(text, /\/MediaBox \[0 0 59[45]\.\d+ 84[12]\.\d+\]/); // 210 by 297 mm in points
    if (shots) writeFileSync(join(shots, `${kind}.pdf`), pdf);
    assert.deepEqual(wrong, []);
    await close();
  });
}

/** Pairs of words of a drawing that lie over each other; turned words as they stand. */
function overlaps(drawing) {
  const corners = (text) => {
    const { x, y, width, height } = text.getBBox();
    const to = text.getScreenCTM();
    const thin = 0.22 * height; // letters do not fill their lines
    return [[x, y + thin], [x + width, y + thin], [x + width, y + height - thin], [x, y + height - thin]].map(([a, b]) => [to.a * a + to.c * b + to.e, to.b * a + to.d * b + to.f]);
  };
  const apart = (a, b) =>
    [a, b].some((box) =>
      [0, 1].some((k) => {
        const axis = [box[k + 1][1] - box[k][1], box[k][0] - box[k + 1][0]];
        const along = (points) => points.map(([x, y]) => x * axis[0] + y * axis[1]);
        const [p, q] = [along(a), along(b)];
        return Math.max(...p) < Math.min(...q) || Math.max(...q) < Math.min(...p);
      }),
    );
  const texts = [...drawing.querySelectorAll('text')].map((one) => [one.textContent, corners(one)]);
  return texts.flatMap(([words, box], k) => texts.slice(k + 1).filter(([, other]) => !apart(box, other)).map(([other]) => `${words} and ${other}`));
}

for (const kind of ['study', 'dual', 'robust', 'simulation', 'sweep', 'studies']) {
  test(`${kind}: no words of a drawing lie over each other`, async () => {
    const { page, close } = await visit(join(folder, kind, 'report.html'));
    const drawings = page.locator('svg.drawing');
    assert.ok((await drawings.count()) > 0);
    for (const one of await drawings.all()) assert.deepEqual(await one.evaluate(overlaps), []);
    await close();
  });
}

test('studies: a drawing names its own study and hash', async () => {
  const { page, close } = await visit(join(folder, 'studies/report.html'));
  const { studies } = await page.evaluate(() => JSON.parse(document.getElementById('page-data').textContent));
  const texts = (await page.$$eval('#flow svg.drawing', (list) => list.map((one) => one.textContent))).join('\n');
  for (const one of studies) assert.ok(texts.includes(`Hash${one.hash}`) && texts.includes(`Study${one.label}`), one.label);
  await close();
});

test('study: warnings are those of the log, beside each design and apart in the front', async () => {
  const { page, close } = await visit(join(folder, 'robust/report.html'));
  const log = lines('robust/evaluations.jsonl').filter((one) => one.status !== 'refused');
  const data = await page.evaluate(() => JSON.parse(document.getElementById('page-data').textContent));
  log.forEach((one, row) => {
    for (const { text } of one.warnings ?? []) assert.ok(data.designs.warnings[row].includes(text), `${one.id}: ${text}`);
  });
  const warned = log.filter((one, row) => data.designs.front[row] && data.designs.warnings[row].length > 0).map((one) => one.id);
  assert.ok(warned.length > 0);
  await page.fill('#designs input[type=search]', 'kind = front (warned), warnings > 0');
  const shown = await page.$$eval('#designs tbody input', (list) => list.map((one) => one.getAttribute('aria-label').replace('Compare design ', '')));
  assert.deepEqual(shown, warned);
  await close();
});

test('study: every surrogate can be looked at, also two of one metric', async () => {
  const { page, wrong, close } = await visit(join(folder, 'robust/report.html'));
  const { metrics } = json('robust/surrogates.json');
  const { slices } = await page.evaluate(() => JSON.parse(document.getElementById('page-data').textContent));
  assert.ok(new Set(slices.metrics.map((one) => one.metric)).size < metrics.length, 'two surrogates are meant to model one metric');
  const options = await page.$$eval('#why label:has-text("Quantity") option', (list) => list.map((one) => one.value));
  assert.deepEqual(options, metrics.map((one) => one.name));
  const titles = new Set();
  for (const one of metrics) {
    await page.selectOption('#why label:has-text("Quantity") select', one.name);
    titles.add(await page.textContent('#why h3'));
  }
  assert.equal(titles.size, metrics.length);
  assert.deepEqual(wrong, []);
  await close();
});

test('study: its numbers are those of the JSON files', async () => {
  const advice = json('study/recommendation.json');
  const { page, close } = await visit(join(folder, 'study/report.html'));
  const { recommended } = advice;
  const expected = [
    ...recommended.variables.filter((one) => one.value !== undefined).map((one) => one.value),
    ...['performance', 'limits', 'loads'].flatMap((part) => advice.page_one[part].map((one) => one.mean)),
  ].filter((value) => value !== null);
  assert.deepEqual(await values(page, '#build'), expected);
  const limits = recommended.constraints.map((one) => one.value).filter((value) => value !== null);
  assert.deepEqual(await values(page, '#sure table:has(caption:text("Limits and margins"))'), limits);
  assert.match(await page.textContent('#build .headline'), new RegExp(`Build design ${recommended.id}`));
  // The sentences of page one, the same as in recommendation.md.
  const built = (await page.textContent('#build')).toLowerCase();
  for (const part of ['verdict_words', 'probability_words', 'chosen', 'ties', 'bounds', 'grid']) assert.ok(built.includes(advice.page_one[part].toLowerCase()), part);
  const repeats = (advice.confirmation?.runs ?? []).flatMap((run) => run.objectives).filter((value) => value !== null);
  assert.deepEqual((await values(page, '#sure table:has(caption:text("simulated again"))')).slice(0, repeats.length), repeats);
  // The whole table, exported.
  const download = page.waitForEvent('download');
  await page.click('#designs button:text("Export as CSV")');
  const csv = readFileSync(await (await download).path(), 'utf8').trim().split('\r\n').map((line) => line.split(','));
  const log = lines('study/evaluations.jsonl').filter((one) => one.status !== 'refused');
  assert.equal(csv.length, log.length + 1);
  const head = csv[0];
  log.forEach((record, k) => {
    const row = Object.fromEntries(head.map((key, c) => [key, csv[k + 1][c]]));
    assert.equal(row.id, record.id);
    for (const [name, value] of Object.entries(record.design)) assert.equal(row[name], String(record.options?.[name] ?? value));
    for (const one of record.objectives) assert.equal(row[one.metric], one.value === null ? '' : String(one.value));
  });
  await close();
});

test('study: sort, filter and select in the table', async () => {
  const { page, wrong, close } = await visit(join(folder, 'study/report.html'));
  const log = lines('study/evaluations.jsonl').filter((one) => one.status !== 'refused');
  const name = Object.keys(log[0].design)[0];
  const column = await page.$$eval('#designs thead button', (list) => list.map((one) => one.textContent));
  const label = column.find((text) => text.toLowerCase().startsWith(name.replace(/_(deg|m)$/, '').replace(/_/g, ' ')));
  await page.click(`#designs thead button:text-is("${label}")`);
  const at = column.indexOf(label);
  const shown = await page.$$eval('#designs tbody tr', (rows, k) => rows.map((row) => Number(row.children[k].querySelector('data').value)), at);
  const sorted = log.map((one) => one.design[name]).sort((a, b) => a - b).slice(0, shown.length);
  assert.deepEqual(shown, sorted);
  const middle = sorted[Math.floor(sorted.length / 2)];
  await page.fill('#designs input[type=search]', `${name} < ${middle}`);
  const below = log.filter((one) => one.design[name] < middle).length;
  await page.waitForFunction((n) => document.querySelector('#designs [role=status]').textContent.startsWith(`${n} of`), below);
  await page.fill('#designs input[type=search]', '');
  const ids = await page.$$eval('#designs tbody input', (list) => list.slice(0, 5).map((one) => one.getAttribute('aria-label').replace('Compare design ', '')));
  for (const id of ids) {
    const box = page.locator(`#designs input[aria-label="Compare design ${id}"]`);
    if (!(await box.isChecked())) await box.check();
  }
  assert.equal(await page.locator('#flow .chosen button').count(), 4); // four at most
  assert.equal(await page.locator('#flow .drawing').count(), 4);
  assert.deepEqual(wrong, []);
  await close();
});

test('study: a click on the front selects, brushing an axis filters every view', async () => {
  const { page, wrong, close } = await visit(join(folder, 'study/report.html'));
  const before = await page.locator('#flow .chosen button').count();
  const chart = page.locator('#else .chart').first();
  await chart.scrollIntoViewIfNeeded();
  await page.waitForTimeout(200);
  // Click where a design must be: the hover text says when the pointer is on one.
  const box = await chart.boundingBox();
  let hit = false;
  for (let y = box.y + 66; y < box.y + box.height - 50 && !hit; y += 9) {
    for (let x = box.x + 86; x < box.x + box.width - 24 && !hit; x += 9) {
      await page.mouse.move(x, y);
      const pointed = await chart.locator('canvas').first().evaluate((canvas) => canvas.parentElement.style.cursor === 'pointer');
      if (!pointed) continue;
      await page.mouse.click(x, y);
      // Other things than designs are pointed at as well, such as the legend.
      hit = Math.abs((await page.locator('#flow .chosen button').count()) - before) === 1;
    }
  }
  assert.ok(hit, 'no click in the chart selects a design');
  const parallel = page.locator('#else .chart').nth(1);
  await parallel.scrollIntoViewIfNeeded();
  await page.waitForTimeout(300);
  const area = await parallel.boundingBox();
  const counter = page.locator('#else [role=status]').first();
  const all = await counter.textContent();
  await page.mouse.move(area.x + 80, area.y + 100);
  await page.mouse.down();
  await page.mouse.move(area.x + 80, area.y + 170, { steps: 4 });
  await page.mouse.move(area.x + 80, area.y + 220, { steps: 4 });
  await page.mouse.up();
  await page.waitForTimeout(300);
  const some = await counter.textContent();
  assert.notEqual(some, all);
  const kept = Number(some.split(' ')[0]);
  assert.match(await page.textContent('#designs [role=status]'), new RegExp(`^${kept} of `));
  await page.click('#else button:text("Clear brushes")');
  assert.equal(await counter.textContent(), all);
  assert.deepEqual(wrong, []);
  await close();
});

test('study: playback in step, by buttons and keys', async () => {
  const { page, wrong, close } = await visit(join(folder, 'study/report.html'));
  await page.locator('#flow').scrollIntoViewIfNeeded();
  const canvas = page.locator('#flow canvas.flow').first();
  await canvas.waitFor();
  const frame = () => canvas.evaluate((one) => Number(one.dataset.frame));
  await page.waitForFunction(() => document.querySelector('#flow canvas.flow').dataset.frame === '0');
  await page.click('#flow .play');
  await page.waitForFunction(() => Number(document.querySelector('#flow canvas.flow').dataset.frame) > 3);
  await page.click('#flow .play');
  const stopped = await frame();
  await page.waitForTimeout(200);
  assert.equal(await frame(), stopped);
  await page.locator('#flow .scrub').focus();
  await page.keyboard.press('ArrowRight');
  await page.waitForFunction((k) => Number(document.querySelector('#flow canvas.flow').dataset.frame) === k, stopped + 1);
  await page.keyboard.press('End');
  await page.waitForFunction(() => {
    const scrub = document.querySelector('#flow .scrub');
    return Math.abs(Number(scrub.value) - Number(scrub.max)) < 1e-6;
  });
  const last = await frame();
  assert.ok(last > stopped);
  await page.keyboard.press('Home');
  await page.waitForFunction(() => document.querySelector('#flow canvas.flow').dataset.frame === '0');
  // The recording's own last frame is at the time at which the run ended.
  for (const what of ['pressure', 'viscosity', 'rest']) {
    const before = await canvas.evaluate((one) => one.toDataURL());
    await page.selectOption('#flow .controls label:has-text("Colour") select', what);
    await page.waitForFunction((old) => document.querySelector('#flow canvas.flow').toDataURL() !== old, before);
  }
  await page.keyboard.press('End');
  await shoot(page, 'playback');
  assert.ok((await page.locator('#flow .cursor').count()) > 0);
  assert.deepEqual(wrong, []);
  await close();
});

test('study: the page holds the licences of what it is made of', async () => {
  const { page, close } = await visit(join(folder, 'study/report.html'));
  const text = await page.textContent('#licences pre');
  for (const name of ['echarts', 'zrender', 'tslib']) assert.ok(text.includes(name), name);
  assert.ok(text.includes('Apache License'));
  await close();
});

test('simulation: metrics are those of result.json; a hostile name stays text', async () => {
  const result = json('simulation/result.json');
  const { page, wrong, close } = await visit(join(folder, 'simulation/report.html'));
  assert.equal(await page.textContent('h1'), result.name);
  assert.ok(/<|"/.test(result.name), 'the name is meant to be hostile');
  assert.equal(await page.locator('main img, main iframe, main object').count(), 0);
  const shown = await values(page, '#sure');
  assert.deepEqual(shown, Object.values(result.metrics).filter((value) => value !== null));
  await page.waitForFunction(() => document.querySelector('#flow canvas.flow')?.dataset.frame !== undefined);
  assert.deepEqual(wrong, []);
  await close();
});

test('sweep: the scorecard holds every printed value', async () => {
  const sweep = json('sweep/table3.json');
  const { page, wrong, close } = await visit(join(folder, 'sweep/report.html'));
  const pairs = sweep.rows.reduce((n, row) => n + Object.keys(row.paper ?? {}).length, 0);
  assert.match(await page.textContent('#answer .table [role=status]'), new RegExp(`of ${pairs} rows`));
  const misses = sweep.rows.reduce((n, row) => n + Object.values(row.agreement ?? {}).filter((one) => one.verdict === 'misses').length, 0);
  const agrees = sweep.rows.reduce((n, row) => n + Object.values(row.agreement ?? {}).filter((one) => one.verdict === 'agrees').length, 0);
  assert.match(await page.textContent('.headline'), new RegExp(`^${agrees} of ${agrees + misses} printed ranges`));
  // As the paper draws them: over the deflector's angle, the two rows of one height on one line.
  await page.selectOption('#figures label:has-text("Quantity") select', 'launch_tip_x_m');
  await page.selectOption('#figures label:has-text("Across") select', 'angle');
  assert.match(await page.getAttribute('#figures .chart', 'aria-label'), /over the deflector angle, 1 line;/);
  await page.locator('#figures').scrollIntoViewIfNeeded();
  await page.waitForTimeout(300);
  assert.deepEqual(wrong, []);
  await close();
});

test('validation: the verdict filters measures and figures', async () => {
  const { page, wrong, close } = await visit(join(folder, 'validation/report.html'));
  await page.selectOption('#answer label:has-text("Verdict") select', 'missed');
  const words = await page.$$eval('#answer tbody .badge', (list) => list.map((one) => one.textContent));
  assert.ok(words.every((word) => word === 'missed'));
  const cases = await page.$$eval('#answer label:has-text("Case") option', (list) => list.map((one) => one.value)).catch(() => []);
  void cases;
  assert.deepEqual(wrong, []);
  await close();
});

test('hostile words anywhere in a study stay words', async () => {
  const marks = '"><img src=x onerror=alert(1)><script>alert(2)</script>{b|x}<!--';
  const file = join(scratch, 'hostile.html');
  writeFileSync(file, studyPage(120, `</title><script>alert(3)</script>`, marks));
  const { page, wrong, close } = await visit(file);
  await look(page);
  assert.equal(await page.locator('main img, main script').count(), 0);
  assert.ok((await page.textContent('.description')).includes(marks));
  assert.deepEqual(wrong, []);
  await close();
});

test('5,000 designs do not freeze the page', async () => {
  const file = join(scratch, 'many.html');
  writeFileSync(file, studyPage(5000));
  const { page, wrong, close } = await visit(file);
  await look(page);
  // The longest time that the page does not answer while a filter is typed and an axis is brushed.
  const longest = await page.evaluate(async () => {
    let last = performance.now();
    let most = 0;
    let watching = true;
    const watch = () => {
      const now = performance.now();
      most = Math.max(most, now - last);
      last = now;
      if (watching) setTimeout(watch);
    };
    watch();
    const filter = document.querySelector('#designs input[type=search]');
    filter.value = 'retention > 0.8';
    filter.dispatchEvent(new Event('input'));
    await new Promise((done) => setTimeout(done, 1500));
    watching = false;
    return most;
  });
  assert.ok(longest < 3000, `${longest} ms without an answer`);
  assert.deepEqual(wrong, []);
  await close();
});

test('a served page hears of new designs', { skip: !process.env.PARAPET }, async () => {
  const study = join(scratch, 'served');
  cpSync(join(folder, 'study'), study, { recursive: true });
  const server = spawn(process.env.PARAPET, ['serve', study], { stdio: ['ignore', 'pipe', 'ignore'] });
  try {
    const address = await new Promise((found) => server.stdout.on('data', (data) => found(String(data).trim())));
    const page = await browser.newPage();
    const wrong = [];
    page.on('console', (message) => message.type() === 'error' && wrong.push(message.text()));
    page.on('pageerror', (error) => wrong.push(error.message));
    await page.goto(address);
    await page.waitForFunction(() => document.documentElement.dataset.ready === 'true');
    assert.match(await page.textContent('.live'), /nothing new yet/); // the study has ended
    const summary = JSON.parse(readFileSync(join(study, 'summary.json'), 'utf8'));
    await page.waitForTimeout(700);
    writeFileSync(join(study, 'summary.json'), JSON.stringify({ ...summary, state: 'running' }));
    await page.waitForFunction(() => document.querySelector('.live').textContent.includes('There is something new'));
    // Shown anew, with the view that was there; while the study runs nothing is to be built.
    const id = await page.$eval('#designs tbody input:not(:checked)', (one) => one.getAttribute('aria-label'));
    await page.check(`#designs input[aria-label="${id}"]`);
    await Promise.all([page.waitForEvent('load'), page.click('.live button')]);
    await page.waitForFunction(() => document.documentElement.dataset.ready === 'true');
    assert.ok(await page.isChecked(`#designs input[aria-label="${id}"]`));
    assert.match(await page.textContent('#build .headline'), /^Best so far: design /);
    assert.match(await page.textContent('.live'), /waiting for the next design/);
    // Following: it comes by itself, but not at once, or nobody could read it.
    await page.check('.live .tick input');
    await page.waitForTimeout(700);
    const start = Date.now();
    const loaded = page.waitForEvent('load');
    writeFileSync(join(study, 'summary.json'), JSON.stringify({ ...summary, state: 'done' }));
    await loaded;
    assert.ok(Date.now() - start > 2000, `${Date.now() - start} ms after the last`);
    await page.waitForFunction(() => document.documentElement.dataset.ready === 'true');
    assert.deepEqual(wrong, []);
    await page.close();
  } finally {
    server.kill('SIGINT');
  }
});

test('studies: one front of all, by the simulated values', async () => {
  const logs = { quickstart: lines('study/evaluations.jsonl'), single_deflector: readFileSync(new URL('../../reports/recommendations/single_deflector/evaluations.jsonl', import.meta.url), 'utf8').trim().split('\n').map((line) => JSON.parse(line)) };
  const { page, wrong, close } = await visit(join(folder, 'studies/report.html'));
  const data = await page.evaluate(() => JSON.parse(document.getElementById('page-data').textContent));
  const all = Object.values(logs).flatMap((log) => log.filter((one) => one.status !== 'refused'));
  assert.equal(data.designs.id.length, all.length);
  const [objective] = data.objectives;
  const best = Math.max(...Object.values(logs).map((log) => {
    const ok = log.filter((one) => one.status === 'ok');
    const finest = Math.min(...ok.map((one) => one.spacing_m));
    return Math.max(...ok.filter((one) => one.feasible && one.spacing_m === finest).map((one) => one.objectives.find((o) => o.metric === objective.name).value));
  }));
  const row = data.designs.front.indexOf(true);
  assert.equal(data.objectives.length, 1);
  assert.equal(data.designs.objectives[objective.name][row], best);
  assert.ok((await page.textContent('#answer table')).includes('single_deflector'));
  assert.match(await page.textContent('#designs [role=status]'), new RegExp(`of ${all.length} rows`));
  assert.deepEqual(wrong, []);
  await close();
});

test('study: series have the discharge and the windows of the loads', async () => {
  const { page, wrong, close } = await visit(join(folder, 'study/report.html'));
  const id = json('study/recommendation.json').recommended.id;
  const record = lines('study/evaluations.jsonl').find((one) => one.id === id);
  const run = await page.evaluate((key) => JSON.parse(document.getElementById('page-data').textContent).runs[key], id);
  const design = run.windows.find((one) => one.key === 'barrier_1_design_force_n_per_m');
  assert.equal(design.value, record.metrics.barrier_1_design_force_n_per_m);
  assert.equal(design.to_s, record.metrics.barrier_1_design_force_time_s);
  assert.ok(Math.abs(design.to_s - design.from_s - 0.7 * Math.sqrt(0.2 / 9.81)) < 1e-9);
  await page.locator('#flow').scrollIntoViewIfNeeded();
  await page.waitForFunction(() => document.querySelector('#flow .compare')?.dataset.ready === 'true');
  const titles = await page.$$eval('#flow figure.panel figcaption', (list) => list.map((one) => one.textContent));
  assert.ok(titles.some((title) => title.startsWith('overflow discharge')), titles.join(', '));
  assert.deepEqual(wrong, []);
  await close();
});

test('a saved copy opens with the view that was saved', async () => {
  const { page, close } = await visit(join(folder, 'study/report.html'));
  const options = await page.$$eval('#else label:has-text("Across") option', (list) => list.map((one) => one.value));
  const other = options[options.length - 1];
  await page.selectOption('#else label:has-text("Across") select', other);
  const ids = await page.$$eval('#designs tbody input', (list) => list.map((one) => one.getAttribute('aria-label').replace('Compare design ', '')));
  const before = await page.locator('#flow .chosen button').allTextContents();
  const more = ids.find((id) => !before.some((text) => text.startsWith(id)));
  await page.check(`#designs input[aria-label="Compare design ${more}"]`);
  await page.locator('#flow').scrollIntoViewIfNeeded();
  await page.waitForFunction(() => document.querySelector('#flow canvas.flow')?.dataset.frame === '0');
  await page.selectOption('#flow .controls label:has-text("Colour") select', 'pressure');
  await page.locator('#flow .scrub').focus();
  for (let k = 0; k < 5; ++k) await page.keyboard.press('ArrowRight');
  await page.fill('#designs input[type=search]', 'stage = search');
  await page.click('.theme');
  const chosen = await page.locator('#flow .chosen button').allTextContents();
  const time = await page.textContent('#flow output.time');
  const rows = await page.textContent('#designs [role=status]');
  const download = page.waitForEvent('download');
  await page.click('header .save');
  const copy = join(scratch, 'copy.html');
  await (await download).saveAs(copy);
  await close();
  const again = await visit(copy);
  assert.equal(await again.page.inputValue('#else label:has-text("Across") select'), other);
  assert.deepEqual(await again.page.locator('#flow .chosen button').allTextContents(), chosen);
  assert.equal(await again.page.textContent('#designs [role=status]'), rows);
  assert.equal(await again.page.getAttribute('html', 'data-theme'), 'dark');
  await again.page.locator('#flow').scrollIntoViewIfNeeded();
  await again.page.waitForFunction(() => document.querySelector('#flow .compare')?.dataset.ready === 'true');
  assert.equal(await again.page.inputValue('#flow .controls label:has-text("Colour") select'), 'pressure');
  assert.equal(await again.page.textContent('#flow output.time'), time);
  assert.deepEqual(again.wrong, []);
  await again.close();
});

test('the theme can be switched', async () => {
  const { page, wrong, close } = await visit(join(folder, 'study/report.html'));
  const paper = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const before = await paper();
  await page.click('.theme');
  assert.notEqual(await paper(), before);
  assert.deepEqual(wrong, []);
  await close();
});
