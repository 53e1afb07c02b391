// Starts Chromium so that wgpu finds the wanted backend and draws in software,
// the same way on every machine.

import { chromium } from 'playwright-core';

const QUIET = [
  '--no-sandbox',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-quic',
  '--disable-sync',
  '--enable-unsafe-swiftshader',
  '--use-angle=swiftshader',
];

/** The arguments under which wgpu takes each backend. The tests assert that it did. */
const BACKEND_ARGUMENTS = {
  // Without the Vulkan flags, buffers that are mapped at creation fail; without
  // --enable-unsafe-webgpu the page silently runs WebGL2.
  WebGPU: [
    '--enable-unsafe-webgpu',
    '--use-webgpu-adapter=swiftshader',
    '--enable-features=Vulkan',
    '--use-vulkan=swiftshader',
  ],
  WebGL2: ['--use-gl=angle'],
};

export const BACKENDS = Object.keys(BACKEND_ARGUMENTS);

/** Software drawing on two busy cores; a state that takes longer is not reached at all. */
const PATIENCE_MS = 60_000;

/** A headless browser for one backend: the program that `CHROMIUM` names, else the one named chromium. */
export function launch(backend) {
  return chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: [...QUIET, ...BACKEND_ARGUMENTS[backend]],
  });
}

/** A page in a context of its own, which waits for everything as patiently as all others. */
export async function newPage(browser, options = {}) {
  const context = await browser.newContext(options);
  context.setDefaultTimeout(PATIENCE_MS);
  return context.newPage();
}
