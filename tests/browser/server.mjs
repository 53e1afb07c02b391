// Serves a folder on a free port of this machine, with the types that a browser insists on,
// compressed if that is asked for, and below any path.

import { createReadStream, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join, normalize, sep } from 'node:path';
import { createGzip } from 'node:zlib';

const TYPES = new Map([
  ['.css', 'text/css'],
  ['.html', 'text/html; charset=utf-8'],
  ['.ico', 'image/x-icon'],
  ['.js', 'text/javascript'],
  ['.json', 'application/json'],
  ['.png', 'image/png'],
  ['.svg', 'image/svg+xml'],
  ['.wasm', 'application/wasm'],
  ['.webmanifest', 'application/manifest+json'],
]);

/** The file that a request means, or null if there is none inside `folder`, which stands for `below`. */
function fileFor(folder, below, url) {
  const whole = decodeURIComponent(new URL(url, 'http://localhost').pathname);
  if (!whole.startsWith(below)) return null;
  const path = whole.slice(below.length - 1);
  const file = normalize(join(folder, path.endsWith('/') ? `${path}index.html` : path));
  const inside = file.startsWith(normalize(folder + sep));
  return inside && statSync(file, { throwIfNoEntry: false })?.isFile() ? file : null;
}

/** Starts serving; `address` is what to open, `close()` ends it. */
export async function serve(folder, { packed = false, below = '/' } = {}) {
  const server = createServer((request, response) => {
    const file = fileFor(folder, below, request.url);
    if (!file) {
      response.writeHead(404).end();
      return;
    }
    const encoding = packed ? { 'content-encoding': 'gzip' } : {};
    response.writeHead(200, { 'content-type': TYPES.get(extname(file)) ?? 'application/octet-stream', ...encoding });
    const content = createReadStream(file);
    (packed ? content.pipe(createGzip({ level: 1 })) : content).pipe(response);
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  const close = () => {
    server.closeAllConnections();
    return new Promise((resolve) => server.close(resolve));
  };
  return { address: `http://127.0.0.1:${server.address().port}${below}`, close };
}
