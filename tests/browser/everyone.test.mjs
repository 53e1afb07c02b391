// Whoever sits before it: with a keyboard alone, by ear, in German, in the dark, for the first time.

import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { App, DEVICES } from './app.mjs';
import { BACKENDS, launch } from './chromium.mjs';
import { serve } from './server.mjs';

const DIST = process.env.RIEMAP_DIST ?? fileURLToPath(new URL('../../dist', import.meta.url));

let site;
before(async () => (site = await serve(DIST)));
after(() => site?.close());

/** What the six steps of the tour are about. */
const TOUR = [/between two shapes/, /Angles stay/, /Three freedoms/, /Harmonic measure/, /Crowding/, /Surfaces/];

// What draws makes no difference here: one backend is enough.
const [BACKEND] = BACKENDS;

describe('everyone', () => {
  let browser;
  before(async () => (browser = await launch(BACKEND)));
  after(() => browser?.close());

  const withApp = (act, device = {}) => async () => {
    const app = await App.open(browser, site.address, { ...DEVICES.desktop, ...device });
    await app.during(() => act(app));
  };

  test(
    'a dot is reached by keyboard alone, and moved by arrow keys, finely with Shift',
    withApp(async (app) => {
      await app.walkTo(/^x₁, interior point of the source/);
      const [x, y] = (await app.stats()).handles.x1;
      await app.press('ArrowRight');
      const moved = (stats, [at, by]) => stats.ready && Math.abs(stats.handles.x1[0] - at - by) < 0.2;
      await app.until('the dot is ten pixels further', moved, [x, 10]);
      await app.press('Shift+ArrowLeft');
      const { handles, undo } = await app.until('the dot is one pixel back', moved, [x, 9]);
      assert.ok(Math.abs(handles.x1[1] - y) < 0.2, 'it has moved along the screen');
      assert.ok(undo >= 1, 'steps of the keyboard can be taken back');
      await app.picture('the-keyboard-on-a-dot');
    }),
  );

  test(
    'the page says what is on the screen, and says it anew when it changes',
    withApp(async (app) => {
      const first = await app.saying('state', /^Conformal map from Gingerbread man to Heart\. x₁ at .* flipped\.$/);
      const { x1 } = (await app.stats()).handles;
      await app.drag(x1, [x1[0] + 30, x1[1] - 20]);
      const second = await app.saying('state', /^Conformal map .* flipped\.$/, first);
      assert.notEqual(second, first);
      await app.loadOutline('source', 'bow.csv', '0,0\n1,1\n1,0\n0,1\n');
      await app.saying('state', /Problem: .*bow.*crosses itself/);
    }),
  );

  test(
    'a German browser is spoken to in German, and everybody can choose',
    withApp(
      async (app) => {
        assert.equal(await app.language(), 'de');
        await app.saying('state', /^Konforme Abbildung von Lebkuchenmann nach Herz\./);
        await app.walkTo(/^Hilfe, Schaltfläche/);
        await app.press('Space');
        await app.walkTo(/^English, Auswahl/);
        await app.press('Space');
        await app.saying('state', /^Conformal map from Gingerbread man to Heart\./);
        assert.equal(await app.language(), 'en');
        await app.reload();
        assert.equal(await app.language(), 'en', 'the choice is kept');
      },
      { locale: 'de-AT' },
    ),
  );

  test(
    'the theme follows the system',
    withApp(
      async (app) => {
        await app.until('light', (stats) => !stats.dark);
        await app.prefer('dark');
        await app.until('dark', (stats) => stats.dark);
      },
      { colorScheme: 'light' },
    ),
  );

  test(
    'the guided tour leads through six pictures and gives the own one back',
    withApp(async (app) => {
      await app.openSession({ texture_scale: 13 });
      await app.until('the own picture', (stats) => stats.ready);
      const mine = await app.session();
      await app.walkTo(/^Help, button/);
      await app.press('Space');
      await app.walkTo(/^Guided tour, button/);
      await app.press('Enter');
      const seen = [];
      for (let step = 1; step <= 6; step++) {
        await app.until(`step ${step} is shown`, (stats) => stats.ready);
        await app.saying('state', TOUR[step - 1]);
        await app.picture(`the-tour-${step}`);
        seen.push(JSON.stringify(await app.session()));
        // the way on has the keyboard
        if (step < 6) await app.press('Enter');
      }
      await app.reload();
      assert.deepEqual(await app.session(), mine, 'a reload brings the own picture back');
      assert.equal(new Set([...seen, JSON.stringify(mine)]).size, 7, 'seven pictures');
    }),
  );

  test(
    'the gallery opens its pictures',
    withApp(
      async (app) => {
        await app.walkTo(/^Help, button/);
        await app.press('Space');
        await app.walkTo(/^Gallery…, button/);
        await app.press('Enter');
        await app.walkTo(/^Square the circle: /, 20);
        await app.picture('the-gallery');
        await app.press('Enter');
        await app.until('the square over the disk', (stats) => stats.ready);
        assert.deepEqual((await app.session()).source.outline, { preset: 'square' });
      },
      DEVICES.phone,
    ),
  );
});
