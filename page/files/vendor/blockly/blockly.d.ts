import * as Blockly from "blockly/core";
export default Blockly;
