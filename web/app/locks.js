// Notices the end of a worker that cannot report it: each worker holds a lock as long as it lives.

/** Resolves when no worker holds the lock of this name; rejects where locks cannot be had. */
const released = (name) => navigator.locks.request(name, () => {});

export const locks = { released };
