// The Set up panel: page, arm, calibration, policy, tokens, virtual arm.

import { html } from "../vendor/lit-html/lit-html.js";
import { isVirtual } from "../state/selectors.js";
import { alerts } from "./set_up/alerts.js";
import { armGuide } from "./set_up/arm.js";
import { calibrateGuide } from "./set_up/calibrate.js";
import { looks } from "./set_up/appearance.js";
import { policy } from "./set_up/policy.js";
import { tokens } from "./set_up/tokens.js";
import { touchPaper } from "./set_up/touch_paper.js";
import { virtualArm } from "./set_up/virtual_arm.js";

/** @param {import("../views/context.js").Context} context */
export const setUp = (context) => html`${looks(context)}${alerts(context)}${armGuide(context)}${calibrateGuide(context)}${touchPaper(context)}${policy(context)}${tokens(context)}${isVirtual(context.page) ? virtualArm(context) : ""}`;
