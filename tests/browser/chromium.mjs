// Starts Chromium so that wgpu finds the requested backend and renders in software,
// identically on every machine.

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

/** The arguments with which wgpu uses each backend. The tests assert that it does. */
const BACKEND_ARGUMENTS = {
  // Without the Vulkan flags, buffers that are mapped at creation fail; without
  // --enable-unsafe-webgpu the page uses WebGL2 without an error.
  WebGPU: [
    '--enable-unsafe-webgpu',
    '--use-webgpu-adapter=swiftshader',
    '--enable-features=Vulkan',
    '--use-vulkan=swiftshader',
  ],
  WebGL2: ['--use-gl=angle'],
};

export const BACKENDS = Object.keys(BACKEND_ARGUMENTS);

/** Enough for software rendering on two busy cores; a state that takes longer is never reached. */
const PATIENCE_MS = 60_000;

/** A headless browser for one backend: the program in `CHROMIUM`, or /usr/bin/chromium. */
export function launch(backend) {
  return chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: [...QUIET, ...BACKEND_ARGUMENTS[backend]],
  });
}

/** A page in its own context, with the common timeout. */
export async function newPage(browser, options = {}) {
  const context = await browser.newContext(options);
  context.setDefaultTimeout(PATIENCE_MS);
  return context.newPage();
}
