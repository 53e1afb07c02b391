// Renders web/icons/*.png from icon.svg. Run `node icons.mjs` in this folder after changing the drawing.
//
// The system crops a maskable icon to a circle or less: for it the drawing is scaled to the middle
// four fifths, and its background fills the square.

import { readFileSync, writeFileSync } from 'node:fs';

import { BACKENDS, launch } from './chromium.mjs';

const FOLDER = new URL('../../web/icons/', import.meta.url);
const GROUND = '#0d1117';
const PICTURES = [
  { name: 'icon-192.png', size: 192 },
  { name: 'icon-512.png', size: 512 },
  { name: 'maskable-512.png', size: 512, maskable: true },
];

const browser = await launch(BACKENDS[0]);
const page = await browser.newPage();
const drawing = readFileSync(new URL('icon.svg', FOLDER), 'utf8');
for (const { name, size, maskable } of PICTURES) {
  const inner = maskable ? 0.8 * size : size;
  const ground = maskable ? GROUND : 'transparent';
  await page.setViewportSize({ width: size, height: size });
  await page.setContent(
    `<style>body{margin:0;width:${size}px;height:${size}px;display:grid;place-items:center;background:${ground}}svg{width:${inner}px}</style>${drawing}`,
  );
  writeFileSync(new URL(name, FOLDER), await page.screenshot({ omitBackground: true }));
}
await browser.close();
