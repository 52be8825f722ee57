// The pictures of docs/page.md, from pages that the program wrote:
//   node browser/pictures.mjs STUDY.html SIMULATION.html STUDIES.html VALIDATION.html FOLDER
// STUDY is of several objectives and its front is recorded, SIMULATION is recorded.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { open } from './open.mjs';

const [study, simulation, studies, validation, folder] = process.argv.slice(2);
const browser = await open();

async function visit(file) {
  const page = await browser.newPage({ viewport: { width: 1180, height: 1010 }, colorScheme: 'light' });
  await page.goto(pathToFileURL(file).href);
  await page.waitForFunction(() => document.documentElement.dataset.ready === 'true');
  return page;
}

/** Shows the flow at a time and waits for its picture and series. */
async function showAt(page, seconds) {
  await page.locator('#flow').scrollIntoViewIfNeeded();
  await page.waitForFunction(() => document.querySelector('#flow .compare')?.dataset.ready === 'true');
  await page.$eval('#flow .scrub', (one, time) => {
    one.value = String(time);
    one.dispatchEvent(new Event('input'));
  }, seconds);
  for (const figure of await page.locator('#flow figure.panel').all()) await figure.scrollIntoViewIfNeeded();
  await page.waitForTimeout(600);
}

/** WebP of a part of the page, from its top, so many pixels high. */
async function picture(page, name, selector, height) {
  await page.$eval(selector, (one) => window.scrollTo({ top: one.getBoundingClientRect().top + scrollY, behavior: 'instant' }));
  await page.waitForTimeout(600);
  const { top, whole } = await page.$eval(selector, (one) => ({ top: one.getBoundingClientRect().top + scrollY, whole: one.getBoundingClientRect().height }));
  await page.evaluate(() => window.scrollTo({ top: 0, behavior: 'instant' })); // the header stays up there
  await page.waitForTimeout(200);
  const clip = { x: 0, y: top, width: 1180, height: Math.min(height, whole) };
  const png = await page.screenshot({ fullPage: true, clip });
  const draw = await browser.newPage();
  const bytes = await draw.evaluate(async (data) => {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const canvas = document.createElement('canvas');
    [canvas.width, canvas.height] = [image.width, image.height];
    canvas.getContext('2d').drawImage(image, 0, 0);
    return canvas.toDataURL('image/webp', 0.8).split(',')[1];
  }, png.toString('base64'));
  await draw.close();
  writeFileSync(join(folder, `${name}.webp`), Buffer.from(bytes, 'base64'));
}

try {
  let page = await visit(study);
  await picture(page, 'page-study', 'body', 1010);
  await picture(page, 'page-else', '#else', 1120);
  const front = await page.evaluate(() => {
    const { designs } = JSON.parse(document.getElementById('page-data').textContent);
    return designs.id.filter((_, row) => designs.front[row]).slice(0, 4);
  });
  for (const id of front) {
    const box = page.locator(`#designs input[aria-label="Compare design ${id}"]`);
    await page.fill('#designs input[type=search]', `design = ${id}`);
    if (!(await box.isChecked())) await box.check();
  }
  await page.fill('#designs input[type=search]', '');
  await showAt(page, 0.6);
  await picture(page, 'page-four', '#flow', 2400);
  page = await visit(simulation);
  await showAt(page, 0.68);
  await picture(page, 'page-playback', '#flow', 1010);
  await picture(await visit(studies), 'page-studies', 'main', 900);
  await picture(await visit(validation), 'page-validation', 'main', 700);
} finally {
  await browser.close();
}
