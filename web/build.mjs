// Builds dist/report.js and dist/report.css, or with an argument the same files in that folder.
import { build } from 'esbuild';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
await build({
  absWorkingDir: here,
  entryPoints: [join(here, 'src/report.ts'), join(here, 'src/report.css')],
  outdir: process.argv[2] ?? join(here, 'dist'),
  bundle: true,
  minify: true,
  format: 'iife',
  target: 'es2022',
  charset: 'ascii',
  legalComments: 'inline',
  logLevel: 'warning',
});
