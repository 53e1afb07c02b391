// What every file of tests stands on: the release web app, served once, and a browser for each of
// wgpu's two backends, in which each test opens pages of its own.

import assert from 'node:assert/strict';
import { after, before, describe } from 'node:test';
import { fileURLToPath } from 'node:url';

import { App, DEVICES } from './app.mjs';
import { BACKENDS, launch, newPage } from './chromium.mjs';
import { watch } from './faults.mjs';
import { serve } from './server.mjs';

/** The folder of the built app. */
export const DIST = process.env.RIEMAP_DIST ?? fileURLToPath(new URL('../../dist', import.meta.url));

/** Describes what `define` lists, with each backend. `how` the app is served: the server's options. */
export function withEachBackend(subject, define, how) {
  describe(subject, () => {
    let site;
    before(async () => (site = await serve(DIST, how)));
    after(() => site?.close());
    for (const backend of BACKENDS) {
      describe(`with ${backend}`, () => {
        let browser;
        before(async () => (browser = await launch(backend)));
        after(() => browser?.close());
        define(new Bench(backend, () => ({ browser, address: site.address })));
      });
    }
  });
}

/** Where the tests with one backend are done. */
class Bench {
  #running;

  constructor(backend, running) {
    this.backend = backend;
    this.#running = running;
  }

  /** Where the app is served; `options` follow, such as "?embed" or a fragment. */
  address(options = '') {
    return this.#running().address + options;
  }

  /** The app at an address, on a device of `app.mjs` or with options of one's own. */
  open(address, { device = 'desktop', ...options } = {}) {
    return App.open(this.#running().browser, address, { backend: this.backend, ...DEVICES[device], ...options });
  }

  /** A test that lets `act` use a freshly opened app; `at`: the options in its address. */
  withApp(act, { at, ...options } = {}) {
    return async (context) => {
      const app = await this.open(this.address(at), options);
      await app.during(() => act(app, context));
    };
  }

  /** A test that lets `act` use an empty page, in which nothing goes wrong but what is `expected`, a pattern. */
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
