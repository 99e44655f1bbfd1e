// The Move panel.

import { html } from "../vendor/lit-html/lit-html.js";
import { buttons } from "./buttons.js";
import { hands } from "./hands.js";
import { jogPanel } from "./jog.js";
import { pads } from "./pads.js";
import { speeds } from "./speeds.js";
import { targetPanel } from "./target.js";
import { tools } from "./tools.js";
import { voice } from "./voice.js";

/** @param {import("../views/context.js").Context} context */
export const move = (context) => html`${jogPanel(context)}${buttons(context)}${targetPanel(context)}${tools(context)}${pads(context)}${speeds(context)}${voice(context)}${hands(context)}`;
