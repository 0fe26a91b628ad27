// Makes dist/page.html, the empty page that the engine fills, from src/ and three.js. `--check` writes nothing and
// fails when the committed page is another.
import { createHash } from 'node:crypto';
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const here = dirname(fileURLToPath(import.meta.url));
const read = (name) => readFileSync(join(here, name), 'utf8');
const output = join(here, 'dist/page.html');

/// Of everything that the page is made from; tests/viewer/check_template.py computes it as well, without npm.
function sourcesHash() {
  const names = [...readdirSync(join(here, 'src')).map((name) => `src/${name}`), 'build.mjs', 'package.json', 'package-lock.json', 'tsconfig.json'].sort();
  const hash = createHash('sha256');
  for (const name of names) hash.update(`${name}\n${read(name)}\n`);
  return hash.digest('hex');
}

const options = { bundle: true, minify: true, write: false, charset: 'ascii', target: 'es2022', absWorkingDir: here };
const style = await build({ ...options, entryPoints: ['src/style.css'] });
const script = await build({ ...options, entryPoints: ['src/main.ts'], format: 'iife', legalComments: 'none' });

const licence = read('node_modules/three/LICENSE').trim().replace(/-->/g, '--');
const notice = `<!--\nPage of Toccata (MIT). Built from ${sourcesHash()}.\nContains three.js:\n\n${licence}\n-->\n`;
const page = read('src/page.html')
  .replace('/*toccata-style*/', () => style.outputFiles[0].text.trim())
  .replace('/*toccata-script*/', () => script.outputFiles[0].text.trim())
  .replace('<html', () => `${notice}<html`)
  .replace(/[^\x00-\x7f]/g, (c) => `&#${c.codePointAt(0)};`);

if (process.argv.includes('--check')) {
  if (readFileSync(output, 'utf8') !== page) {
    console.error('apps/viewer/dist/page.html is not what its sources make: run npm ci && npm run build in apps/viewer');
    process.exit(1);
  }
  console.log('dist/page.html is what its sources make');
} else {
  writeFileSync(output, page);
  console.log(`dist/page.html: ${page.length} bytes`);
}
