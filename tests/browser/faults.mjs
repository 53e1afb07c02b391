// Faults of a page that the user may not see: uncaught errors, files that cannot be loaded, and errors that the
// browser logs to its console.

/** Warnings that count as errors. */
const SERIOUS = /WebGL: |WebGPU|validation|\[Intervention\]|Content Security Policy/i;

const isFault = (message) => message.type() === 'error' || (message.type() === 'warning' && SERIOUS.test(message.text()));

/** A growing list of the faults of all pages of a context, without those that match `expected`. */
export function watch(context, expected = null) {
  const faults = [];
  const note = (fault) => expected?.test(fault) || faults.push(fault);
  context.on('weberror', (event) => note(`uncaught: ${event.error().stack ?? event.error()}`));
  context.on('requestfailed', (request) => {
    // a reload aborts pending requests, such as that for the icon
    if (request.failure()?.errorText !== 'net::ERR_ABORTED') note(`not loaded: ${request.url()}`);
  });
  context.on('console', (message) => {
    if (isFault(message)) note(`console: ${message.text()} (${message.location().url})`);
  });
  return faults;
}
