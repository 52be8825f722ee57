// Bundles src/ into dist/page.js and dist/page.css, and with --tests the unit tests into build/test/.
// The bundle is committed: the program embeds it, and nobody needs Node.js to build Parapet.
import { build } from 'esbuild';
import { mkdir, readFile, readdir, rm, writeFile } from 'node:fs/promises';

const common = { bundle: true, target: 'es2020', charset: 'utf8', logLevel: 'warning' };

// The packages that the bundle holds, by the files that went into it.
async function licences(metafile) {
  const packages = new Set();
  for (const file of Object.keys(metafile.inputs)) {
    const found = /node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(file);
    if (found) packages.add(found[1]);
  }
  let text = '';
  for (const name of [...packages].sort()) {
    const folder = `node_modules/${name}`;
    const { version, license } = JSON.parse(await readFile(`${folder}/package.json`, 'utf8'));
    text += `${name} ${version} (${license})\n\n`;
    for (const entry of (await readdir(folder, { withFileTypes: true })).sort((a, b) => (a.name < b.name ? -1 : 1))) {
      if (!/^(licen[cs]e|notice)/i.test(entry.name)) continue;
      const path = `${folder}/${entry.name}`;
      const files = entry.isDirectory() ? (await readdir(path)).sort().map((file) => `${path}/${file}`) : [path];
      for (const file of files) text += `${(await readFile(file, 'utf8')).trim()}\n\n`;
    }
  }
  return text.replace(/[ \t]+$/gm, '').trim() + '\n';
}

async function page() {
  const result = await build({
    ...common,
    entryPoints: { page: 'src/main.ts' },
    outdir: 'dist',
    format: 'iife',
    minify: true,
    legalComments: 'none',
    metafile: true,
    define: { 'process.env.NODE_ENV': '"production"' },
  });
  await writeFile('dist/licences.txt', await licences(result.metafile));
}

async function tests() {
  await rm('build/test', { recursive: true, force: true });
  await mkdir('build/test', { recursive: true });
  const files = (await readdir('test')).filter((file) => file.endsWith('.test.ts'));
  await build({
    ...common,
    entryPoints: files.map((file) => `test/${file}`),
    outdir: 'build/test',
    outExtension: { '.js': '.mjs' },
    format: 'esm',
    platform: 'node',
  });
}

await (process.argv.includes('--tests') ? tests() : page());
