// A store: one state, changed only by messages, with subscribers.

/**
 * @template S, M
 * @param {(state: S, message: M) => S} reduce
 * @param {S} state
 */
export function createStoreCore(reduce, state) {
  /** @type {((state: S, message: M) => void)[]} */
  const listeners = [];
  return {
    /** The state, as it is now. */
    get page() {
      return state;
    },
    /** @param {M} message */
    send(message) {
      state = reduce(state, message);
      for (const listener of listeners) listener(state, message);
    },
    /** @param {(state: S, message: M) => void} listener */
    subscribe(listener) {
      listeners.push(listener);
    },
  };
}
