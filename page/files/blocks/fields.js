// The fields of blocks, without those habits of Blockly's that change what a person typed: no clamping, no guessing.

import Blockly from "../vendor/blockly/blockly.js";

/** A number as it is typed: no thousands separators, no range. Anything else is refused, a decimal comma too. */
export class ExactNumber extends Blockly.FieldNumber {
  /** @param {unknown} value @returns {number | null} */
  doClassValidation_(value) {
    const text = String(value).trim();
    return text !== "" && Number.isFinite(Number(text)) ? Number(text) : null;
  }
}

/** A choice that also holds a value which is none of its options, such as the name of a point that is not there yet. */
export class OpenDropdown extends Blockly.FieldDropdown {
  /** @type {string} */ asked = "";

  /** @param {() => [string, string][]} options */
  constructor(options) {
    super(Blockly.FieldDropdown.SKIP_SETUP);
    this.setOptions(() => {
      const all = options();
      const { asked } = this;
      return all.some(([, value]) => value === asked) ? all : [[asked || "…", asked], ...all];
    });
    this.setValue("");
  }

  /** @param {unknown} value @returns {string} */
  doClassValidation_(value) {
    this.asked = String(value);
    this.getOptions(false);
    return this.asked;
  }
}

/** A menu of what can be added to a block and removed from it; nothing is ever selected. */
export class OfferMenu extends Blockly.FieldDropdown {
  SERIALIZABLE = false;

  /** @param {() => [string, string][]} options @param {(index: number) => void} take @param {string} label */
  constructor(options, take, label) {
    super(() => [["⋯", ""], ...options()], (value) => {
      if (value !== "") queueMicrotask(() => take(Number(value)));
      return null;
    }, { tooltip: label });
  }
}
