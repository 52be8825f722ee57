// Pages and recordings of any size, made without the program: for limits and times.
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { deflateSync } from 'node:zlib';

const dist = new URL('../dist/', import.meta.url);
const read = (name) => readFileSync(new URL(name, dist), 'utf8');
const hash = (text) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;

/** The HTML as reports/src/page/page_html.cpp writes it. */
export function pageHtml(page, blocks = []) {
  const [script, style] = [read('page.js'), read('page.css')];
  const data = JSON.stringify(page).replace(/</g, '\\u003c');
  const policy = `default-src 'none'; script-src ${hash(script)}; style-src ${hash(style)}; img-src data:; base-uri 'none'; form-action 'none'`;
  return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>fixture</title>
<style>${style}</style>
</head>
<body>
<div id="page-blocks" hidden>
<script type="application/json" id="page-data">${data}</script>
${blocks.map((one) => `<script type="text/plain" id="${one.id}">${one.bytes.toString('base64')}</script>`).join('\n')}
<div id="page-licences">licences</div>
</div>
<script>${script}</script>
</body>
</html>
`;
}

export const scene = {
  slope_deg: 26,
  gravity_m_s2: 9.81,
  domain: { length_m: 3, height_m: 1.5 },
  reservoir: { length_m: 0.3, height_m: 0.2 },
  monitor_x_m: 1.1,
  density_kg_m3: 1135,
  barriers: [
    {
      foot_x_m: 1.1,
      height_m: 0.1,
      thickness_m: 0.015,
      stem_lean_deg: 0,
      deflector: { angle_deg: 45, length_m: 0.065 },
      outline: [[1.1, 0], [1.056, 0.09], [1.035, 0.151], [1.049, 0.156], [1.0745, 0.1005], [1.1167, 0]],
    },
  ],
  solids: [],
};

/** A recording of n particles that slide down the channel: every field changes in every frame. */
export function recording(n, frames) {
  const perChunk = 16;
  const spacing = Math.sqrt((0.3 * 0.2) / n);
  const step = spacing / 8;
  const origin = -16 * spacing;
  const chunks = [];
  const rows = Math.round(0.2 / spacing);
  for (let first = 0; first < frames; first += perChunk) {
    const count = Math.min(perChunk, frames - first);
    const codes = [];
    for (let k = 0; k < count; ++k) {
      const t = 0.02 * (first + k);
      const frame = Array.from({ length: 5 }, () => new Uint16Array(n));
      for (let i = 0; i < n; ++i) {
        const wobble = Math.sin(7 * t + i) * 0.5;
        const x = Math.floor(i / rows) * spacing + 0.4 * t * t + 0.02 * wobble * t;
        const z = (i % rows) * spacing * (1 - 0.3 * Math.min(1, t)) + 0.001 * wobble;
        frame[0][i] = (Math.min(x, 2.9) - origin) / step;
        frame[1][i] = (z - origin) / step;
        frame[2][i] = 80 * t + 10 * wobble + 10;
        frame[3][i] = 32768 + 50 * wobble;
        frame[4][i] = 100 + 8 * wobble;
      }
      codes.push(frame);
    }
    const raw = Buffer.alloc(11 * count * n);
    for (let field = 0; field < 5; ++field) {
      const low = 2 * field * count * n;
      const high = low + count * n;
      for (let k = 0; k < count; ++k) {
        for (let i = 0; i < n; ++i) {
          let expected = 0;
          if (k === 0) expected = i === 0 ? 0 : codes[0][field][i - 1];
          else if (k === 1 || field > 1) expected = codes[k - 1][field][i];
          else expected = 2 * codes[k - 1][field][i] - codes[k - 2][field][i];
          const difference = ((codes[k][field][i] - expected) << 16) >> 16;
          const word = ((difference << 1) ^ (difference >> 31)) & 0xffff;
          raw[low + k * n + i] = word & 255;
          raw[high + k * n + i] = word >> 8;
        }
      }
    }
    raw.fill(1, 10 * count * n);
    chunks.push(deflateSync(raw));
  }
  const header = Buffer.from(
    JSON.stringify({
      format: 'parapet-recording/1',
      name: 'fixture',
      spacing_m: spacing,
      particles: n,
      times_s: Array.from({ length: frames }, (_, k) => 0.02 * k),
      chunk_bytes: chunks.map((chunk) => chunk.length),
      frames_per_chunk: perChunk,
      reach_m: [0, 0, 2.9, 0.25],
      scene,
      steps: { length_m: step, origin_m: origin, speed_m_s: 0.0099, pressure_pa: 11.13, viscosity_ratio: 2 ** 0.125, least_viscosity_pa_s: 0.001, rest_speed_m_s: 0.0198 },
    }),
  );
  const size = Buffer.alloc(4);
  size.writeUInt32LE(header.length);
  return Buffer.concat([Buffer.from('PARAPET\n'), size, header, ...chunks]);
}

const common = (kind, name) => ({
  format: 'parapet-page/1',
  kind,
  name,
  description: 'Made for a test.',
  date: '2026-01-01T00:00:00Z',
  hash: '0123456789abcdef',
  program: { version: '0.0.0' },
  keys: {},
  commands: [{ what: 'recommend', command: 'parapet recommend DIR' }],
  runs: {},
  live: false,
});

/** A simulation with a recording. */
export function simulationPage(particles, frames, name = 'fixture') {
  const page = common('simulation', name);
  page.keys = { launch_length_m: { words: 'launch length', unit: 'm', definition: 'how far' } };
  page.runs[name] = { scene, recording: 'recording-0' };
  page.result = {
    name,
    status: 'ok',
    reason: '',
    stop_reason: 'metrics_final',
    stop_time_s: 0.02 * (frames - 1),
    metrics: { launch_length_m: 0.25 },
    metrics_absent: {},
    mass: {},
    statistics: {},
  };
  return pageHtml(page, [{ id: 'recording-0', bytes: recording(particles, frames) }]);
}

/** A study of n designs with four variables, two objectives, a limit and twelve metrics. */
export function studyPage(n, name = 'fixture', marks = '') {
  const page = common('study', name);
  const variables = ['angle_deg', 'height_m', 'length_m', 'place_m'];
  const objectives = [
    { name: 'retention', goal: 'maximize' },
    { name: 'launch_m', goal: 'minimize' },
  ];
  const metrics = Array.from({ length: 12 }, (_, k) => `metric_${k}_m`);
  let seed = 12345;
  const random = () => (seed = (seed * 1103515245 + 12345) % 2147483648) / 2147483648;
  const list = (make) => Array.from({ length: n }, (_, k) => make(k));
  const values = Object.fromEntries(variables.map((key) => [key, list(random)]));
  const retention = list((k) => 1 - 0.5 * values.angle_deg[k] ** 2 - 0.2 * random());
  const launch = list((k) => values.height_m[k] + 0.3 * (1 - values.angle_deg[k]) + 0.1 * random());
  const designs = {
    id: list((k) => String(k + 1).padStart(4, '0')),
    stage: list((k) => (k < 10 ? 'start' : 'search')),
    spacing_m: list(() => 0.005),
    status: list((k) => (k % 97 === 96 ? 'failed' : 'ok')),
    reason: list((k) => (k % 97 === 96 ? `no reason ${marks}` : '')),
    feasible: list((k) => k % 97 !== 96 && retention[k] > 0.5),
    front: list((k) => retention.every((r, j) => !(r >= retention[k] && launch[j] <= launch[k] && (r > retention[k] || launch[j] < launch[k])))),
    stop_reason: list(() => 'metrics_final'),
    warnings: list(() => []),
    variables: values,
    objectives: { retention, launch_m: launch },
    constraints: { [`limit ${marks}`]: list(random) },
    metrics: Object.fromEntries(metrics.map((key) => [key, list(random)])),
  };
  for (const key of [...variables, 'retention', 'launch_m', ...metrics]) {
    page.keys[key] = { words: `${key.replace(/_(m|deg)$/, '').replace(/_/g, ' ')}${marks}`, unit: key.endsWith('_m') ? 'm' : '' };
  }
  const first = Math.max(0, designs.front.indexOf(true));
  const shown = {
    id: designs.id[first],
    stage: 'search',
    spacing_m: 0.005,
    variables: variables.map((key) => ({ name: key, value: values[key][first], lower: 0, upper: 1, at_bound: null })),
    objectives: objectives.map((one) => ({ ...one, value: designs.objectives[one.name][first] })),
    constraints: [{ name: `limit ${marks}`, value: 0.4, lower: null, upper: 0.5, satisfied: true, margin: 0.1, margin_percent: 20, active: false }],
    metrics: Object.fromEntries(metrics.map((key) => [key, designs.metrics[key][first]])),
    metrics_absent: {},
    estimates: [],
    probability_feasible: 0.97,
  };
  const pageOne = {
    title: `Recommended arrangement ${marks}`, design: shown.id, arrangement: `an arrangement ${marks}`, instead: '',
    performance: objectives.map((one) => ({ label: `${one.name} ${marks}`, text: '0.9 ± 0.1', asked: `to be ${one.goal}d`, mean: 0.9, lower_95: 0.8, upper_95: 1, probability: null })),
    limits: [{ label: `limit ${marks}`, text: '0.4 ± 0.1', asked: 'at most 0.5', mean: 0.4, lower_95: 0.3, upper_95: 0.5, probability: 0.97 }],
    loads: [], probability: 0.97, probability_words: 'probability 97 %', chosen: `the knee ${marks}`, ties: `ties ${marks}`,
    bounds: `bounds ${marks}`, grid: 'grid', verdict: 'confirmed', verdict_words: 'Confirmed by 2 further runs',
  };
  page.runs[shown.id] = { scene, record_command: `parapet report DIR --record ${shown.id}` };
  return pageHtml({
    ...page,
    description: `Made for a test. ${marks}`,
    state: 'done',
    recommendation: { page_one: pageOne, rule: { name: 'knee', words: `the knee ${marks}` }, recommended: shown, front: [], caveats: [`caveat ${marks}`] },
    variables: variables.map((key) => ({ name: key, lower: 0, upper: 1 })),
    objectives,
    finest_spacing_m: 0.005,
    designs,
    slices: null,
  });
}
