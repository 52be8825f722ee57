import './page.css';
import { readPage } from './blocks';
import type { Page } from './data';
import { h } from './dom';
import { Keys, programText } from './format';
import { liveBar } from './live';
import { simulationSections } from './simulation';
import { studiesSections } from './studies';
import { studySections } from './study';
import { sweepSections } from './sweep';
import { themeButton } from './theme';
import { saveButton } from './view';
import { validationSections } from './validation';

const kindWords: Record<Page['kind'], string> = {
  study: 'Study',
  simulation: 'Simulation',
  sweep: 'Sweep',
  validation: 'Validation',
  studies: 'Studies',
};

function sectionsOf(page: Page): HTMLElement[] {
  const keys = new Keys(page);
  switch (page.kind) {
    case 'study':
      return studySections(page, keys);
    case 'studies':
      return studiesSections(page, keys);
    case 'simulation':
      return simulationSections(page, keys);
    case 'sweep':
      return sweepSections(page, keys);
    case 'validation':
      return validationSections(page);
  }
}

function show(page: Page): void {
  const sections = sectionsOf(page);
  const links = sections.map((one) => h('a', { href: `#${one.id}` }, one.querySelector('h2')!.textContent));
  document.title = `${page.name} – Parapet`;
  document.body.replaceChildren(
    h('a', { class: 'skip', href: '#main' }, 'To the content'),
    h(
      'header',
      {},
      h('div', { class: 'title' }, h('span', { class: 'kind-of-page' }, kindWords[page.kind]), h('h1', {}, page.name)),
      h('nav', { 'aria-label': 'Parts of this page' }, ...links),
      saveButton(page.name),
      themeButton(),
    ),
    h('main', { id: 'main', tabindex: -1 }, page.description ? h('p', { class: 'description' }, page.description) : '', page.live && location.protocol === 'http:' ? liveBar(page.kind === 'study' ? page.state : '') : '', ...sections),
    h('footer', {}, `Written by ${programText(page.program)} on ${page.date.slice(0, 10)}. This page asks for nothing from anywhere.`),
  );
  document.documentElement.dataset['ready'] = 'true';
}

// What holds the data leaves the body with the first rendering, but is still needed: keep it aside.
const store = document.getElementById('page-blocks');
if (store) document.head.append(store);
try {
  show(readPage());
} catch (error) {
  document.body.replaceChildren(h('main', {}, h('h1', {}, 'This page is damaged'), h('p', { role: 'alert' }, String(error))));
}
