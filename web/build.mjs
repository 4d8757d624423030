// Builds the scripts and styles of report.html and of the coordinator's page into dist, or with an argument the same files in that folder.
import { build } from 'esbuild';
import { copyFileSync, mkdirSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const outdir = process.argv[2] ?? join(here, 'dist');
mkdirSync(outdir, { recursive: true });
copyFileSync(join(here, 'node_modules/three/examples/jsm/libs/draco/gltf/draco_decoder.js'), join(outdir, 'draco_decoder.js'));
await build({
  absWorkingDir: here,
  entryPoints: [join(here, 'src/report.ts'), join(here, 'src/report.css'),
    join(here, 'src/console.ts'), join(here, 'src/console.css')],
  outdir,
  bundle: true,
  minify: true,
  format: 'iife',
  target: 'es2022',
  charset: 'ascii',
  define: { 'import.meta.url': 'document.baseURI' },
  legalComments: 'inline',
  logLevel: 'warning',
});
