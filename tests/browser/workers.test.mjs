// Workers that are terminated or hang: noticed, replaced, and given the request again, once.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { withOneBackend } from './backends.mjs';

/** Runs in the page before its scripts: lets a test terminate workers that get a request, or withhold requests. */
function makeWorkersMortal() {
  window.mortal = { kills: 0, hangs: 0, requests: 0, later: 0 };
  const { post, end } = { post: Worker.prototype.postMessage, end: Worker.prototype.terminate };
  Worker.prototype.postMessage = function (message, ...rest) {
    // equations and refined meshes follow by themselves
    if (!message?.task?.startsWith('outline')) return post.call(this, message, ...rest);
    window.mortal.requests++;
    if (window.mortal.hangs > 0) {
      window.mortal.hangs--;
      return undefined;
    }
    const posted = post.call(this, message, ...rest);
    if (window.mortal.kills > 0) {
      window.mortal.kills--;
      // as the browser does when the memory is short: the page is not told
      end.call(this);
    }
    return posted;
  };
  const now = performance.now.bind(performance);
  performance.now = () => now() + window.mortal.later;
}

const mortal = (app, changes) => app.page.evaluate((given) => Object.assign(window.mortal, given), changes);

withOneBackend('workers', (bench) => {
  test(
    'a worker that is terminated is replaced, and its request is sent again',
    bench.withApp(
      async (app) => {
        await mortal(app, { kills: 1, requests: 0 });
        await app.loadOutline('source', 'triangle.csv', '0,0\n3,0\n1,2\n');
        const { errors } = await app.until('the outline is prepared', (stats) => stats.ready && stats.undo === 1);
        assert.deepEqual(errors, []);
        assert.equal((await app.session()).source.outline.points.name, 'triangle');
      },
      { prepare: makeWorkersMortal },
    ),
  );

  test(
    'a second failure of the same request is reported, and it can be repeated',
    bench.withApp(
      async (app) => {
        await mortal(app, { kills: 2, requests: 0 });
        await app.openSession({ source: { ...(await app.session()).source, outline: { preset: 'star' } } });
        await app.page.waitForFunction(() => window.mortal.requests === 2);
        // the second worker is terminated before it runs, and so has not said that it does
        await mortal(app, { later: 60_000 });
        const { errors } = await app.until('it is said', (stats) => stats.errors.length > 0);
        assert.match(errors.join(' '), /stopped unexpectedly \(it (was terminated|did not respond)/);
        assert.equal(await app.page.evaluate(() => window.mortal.requests), 2, 'no endless loop');
        await app.shot('worker-terminated');
      },
      { prepare: makeWorkersMortal },
    ),
  );

  test(
    'a worker that hangs is replaced after its time, and its request is sent again',
    bench.withApp(
      async (app) => {
        await mortal(app, { hangs: 1, requests: 0 });
        await app.loadOutline('source', 'triangle.csv', '0,0\n3,0\n1,2\n');
        await app.page.waitForFunction(() => window.mortal.requests === 1);
        assert.equal((await app.stats()).preparing[0], true);
        await mortal(app, { later: 200_000 });
        const { errors } = await app.until('the outline is prepared', (stats) => stats.ready && stats.undo === 1);
        assert.deepEqual(errors, []);
      },
      { prepare: makeWorkersMortal },
    ),
  );
});
