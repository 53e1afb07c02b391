// Keyboard only, screen reader, German, dark theme, first visit.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { withOneBackend } from './backends.mjs';

/** The topics of the tour's six steps. */
const TOUR = [/between two shapes/, /Angles stay/, /Three freedoms/, /Harmonic measure/, /Crowding/, /Surfaces/];

withOneBackend('everyone', (bench) => {
  test(
    'a dot is reached by keyboard alone, and moved by arrow keys, finely with Shift',
    bench.withApp(async (app) => {
      await app.walkTo(/^x₁, interior point of the source/);
      const [x, y] = (await app.stats()).handles.x1;
      await app.press('ArrowRight');
      const moved = (stats, [at, by]) => stats.ready && stats.undo > 0 && Math.abs(stats.handles.x1[0] - at - by) < 0.2;
      await app.until('the dot is ten pixels further, and that can be taken back', moved, [x, 10]);
      await app.press('Shift+ArrowLeft');
      const { handles } = await app.until('the dot is one pixel back', moved, [x, 9]);
      assert.ok(Math.abs(handles.x1[1] - y) < 0.2, 'it has moved along the screen');
      await app.shot(`${bench.backend}-the-keyboard-on-a-dot`);
    }),
  );

  test(
    'the page says what is on the screen, and says it anew when it changes',
    bench.withApp(async (app) => {
      const first = await app.saying('state', /^Conformal map from Gingerbread man to Heart\. x₁ at .* flipped\.$/);
      const { x1 } = (await app.stats()).handles;
      await app.drag(x1, [x1[0] + 30, x1[1] - 20]);
      await app.saying('state', /^Conformal map .* flipped\.$/, first);
      await app.loadOutline('source', 'bow.csv', '0,0\n1,1\n1,0\n0,1\n');
      await app.saying('state', /Problem: .*bow.*crosses itself/);
      await app.loadOutline('source', 'line.csv', '0,0\n1,0\n');
      await app.saying('state', /Problem: .*line\.csv/);
    }),
  );

  test(
    'a German browser gets German text, and everybody can choose',
    bench.withApp(
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
    bench.withApp(
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
    bench.withApp(async (app) => {
      const first = await app.otherAddress(bench.address());
      await app.openSession({ texture_scale: 13 });
      await app.otherAddress(first); // so that the user's own session is stored
      const mine = await app.session();
      await app.walkTo(/^Help, button/);
      await app.press('Space');
      await app.walkTo(/^Guided tour, button/);
      await app.press('Enter');
      const seen = [];
      for (let step = 1; step <= 6; step++) {
        await app.saying('state', TOUR[step - 1]);
        await app.until(`step ${step} is shown`, (stats) => stats.ready);
        await app.shot(`${bench.backend}-the-tour-${step}`);
        seen.push(JSON.stringify(await app.session()));
        // the button "Next" has the focus from the first frame on
        if (step < 6) await app.press('Enter');
      }
      await app.reload();
      assert.deepEqual(await app.session(), mine, 'a reload brings the own picture back');
      assert.equal(new Set([...seen, JSON.stringify(mine)]).size, 7, 'seven pictures');
    }),
  );

  test(
    'windows are closed by a finger on a phone',
    bench.withApp(
      async (app) => {
        const before = await app.session();
        const closed = async (name) => {
          const { close } = await app.atRest(`it is open: ${name}`, (stats, wanted) => stats.close[wanted], name);
          await app.shot(`${bench.backend}-to-close-${name}`);
          await app.tap(close[name]);
          await app.until(`it is closed: ${name}`, (stats, wanted) => !stats.close[wanted], name);
        };
        for (const [entry, name] of [[/^Gallery…, button/, 'Gallery'], [/^Keys and gestures…, button/, 'Keys']]) {
          await app.walkTo(/^Help, button/);
          await app.press('Space');
          await app.walkTo(entry);
          await app.press('Enter');
          await closed(name);
        }
        await app.press('Control+e');
        const { export: places } = await app.atRest('the exports are open', (stats) => stats.export?.Close);
        await app.tap(places.Close);
        await app.until('they are closed', (stats) => stats.export === null);
        assert.deepEqual(await app.session(), before, 'what is behind them is not touched');
      },
      { device: 'phone' },
    ),
  );

  test(
    'the gallery opens its pictures',
    bench.withApp(
      async (app) => {
        await app.walkTo(/^Help, button/);
        await app.press('Space');
        await app.walkTo(/^Gallery…, button/);
        await app.press('Enter');
        await app.atRest('the gallery is open', (stats) => stats.close.Gallery);
        await app.walkTo(/^Square the circle: /);
        await app.shot(`${bench.backend}-the-gallery`);
        await app.press('Enter');
        await app.until('the square over the disk', (stats) => stats.ready);
        assert.deepEqual((await app.session()).source.outline, { preset: 'square' });
      },
      { device: 'phone' },
    ),
  );
});
