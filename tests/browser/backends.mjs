// Shared by all test files: serves the release web app once, and starts a browser for each of
// wgpu's two backends, or for one where nothing depends on how the pictures are drawn. Each test opens its own pages.

import assert from 'node:assert/strict';
import { after, before, describe } from 'node:test';
import { fileURLToPath } from 'node:url';

import { App, DEVICES } from './app.mjs';
import { BACKENDS, launch, newPage } from './chromium.mjs';
import { watch } from './faults.mjs';
import { serve } from './server.mjs';

/** The folder of the built app. */
export const DIST = process.env.RIEMAP_DIST ?? fileURLToPath(new URL('../../dist', import.meta.url));

/** Defines the tests of `define` for each backend. `how`: the options of the server. */
export function withEachBackend(subject, define, how) {
  withBackends(BACKENDS, subject, define, how);
}

/** Defines the tests of `define` for the backend that wgpu prefers. */
export function withOneBackend(subject, define, how) {
  withBackends(BACKENDS.slice(0, 1), subject, define, how);
}

function withBackends(backends, subject, define, how) {
  describe(subject, () => {
    let site;
    before(async () => (site = await serve(DIST, how)));
    after(() => site?.close());
    for (const backend of backends) {
      describe(`with ${backend}`, () => {
        let browser;
        before(async () => (browser = await launch(backend)));
        after(() => browser?.close());
        define(new Bench(backend, () => ({ browser, address: site.address })));
      });
    }
  });
}

/** The environment of the tests with one backend. */
class Bench {
  #running;

  constructor(backend, running) {
    this.backend = backend;
    this.#running = running;
  }

  /** The address of the app, followed by `options`, such as "?embed" or a fragment. */
  address(options = '') {
    return this.#running().address + options;
  }

  /** Opens the app at an address, on a device of `app.mjs` or with other options. */
  open(address, { device = 'desktop', ...options } = {}) {
    return App.open(this.#running().browser, address, { backend: this.backend, ...DEVICES[device], ...options });
  }

  /** A test that runs `act` on a newly opened app; `at`: the options in its address. */
  withApp(act, { at, ...options } = {}) {
    return async (context) => {
      const app = await this.open(this.address(at), options);
      await app.during(() => act(app, context));
    };
  }

  /** A test that runs `act` on an empty page and allows no faults except those that match `expected`. */
  withPage(act, { expected, ...options } = {}) {
    return async () => {
      const page = await newPage(this.#running().browser, options);
      const faults = watch(page.context(), expected);
      try {
        await act(page);
      } finally {
        await page.context().close();
      }
      assert.deepEqual(faults, [], 'nothing goes wrong behind the scenes');
    };
  }
}
