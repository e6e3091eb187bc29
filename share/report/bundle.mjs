// SPDX-License-Identifier: GPL-3.0-or-later
// Bundles src/main.js into one script with the licences of all packages that are in it: node bundle.mjs view.js
import { build } from 'esbuild';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';

const result = await build({
  entryPoints: ['src/main.js'],
  bundle: true,
  minify: true,
  format: 'iife',
  target: 'es2020',
  charset: 'utf8',
  legalComments: 'none', // they come whole, below
  metafile: true,
  write: false,
  outfile: 'view.js',
});

const inside = Object.entries(Object.values(result.metafile.outputs)[0].inputs).filter(([, part]) => part.bytesInOutput > 0);
const names = new Set(inside.map(([file]) => file.match(/^node_modules\/((?:@[^/]+\/)?[^/]+)/)?.[1]).filter(Boolean));
const licences = [...names].sort().map((name) => {
  const folder = `node_modules/${name}`;
  const about = JSON.parse(readFileSync(`${folder}/package.json`, 'utf8'));
  const author = about.author?.name ?? about.author ?? '';
  const file = readdirSync(folder).find((entry) => /^licen[cs]e/i.test(entry));
  const text = file ? readFileSync(`${folder}/${file}`, 'utf8').trim() : '';
  return `${name} ${about.version}, ${about.license}${author ? `, ${author}` : ''}\n${text}`;
});
const notice = licences.join('\n\n').replaceAll('*/', '* /').replaceAll('</', '< /');
const script = result.outputFiles[0].text.replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');
writeFileSync(process.argv[2], `/*! This view holds\n\n${notice}\n*/\n${script}`);
