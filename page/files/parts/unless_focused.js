// Sets a field's value from the state, except while the field has the focus: unfinished input is not state.

import { Directive, directive } from "../vendor/lit-html/directive.js";
import { setCommittedValue } from "../vendor/lit-html/directive-helpers.js";
import { noChange } from "../vendor/lit-html/lit-html.js";

class UnlessFocused extends Directive {
  /** @param {string} value */
  render(value) {
    return value;
  }

  /** @override @param {import("../vendor/lit-html/lit-html.js").PropertyPart} part @param {[string]} args */
  update(part, [value]) {
    const field = /** @type {HTMLInputElement} */ (part.element);
    if (field.matches(":focus") || field.value === value) return noChange;
    // Whatever was set before is not what the field shows.
    setCommittedValue(part);
    return value;
  }
}

/** For `.value=${unlessFocused(text)}`. */
export const unlessFocused = directive(UnlessFocused);
