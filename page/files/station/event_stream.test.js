import assert from "node:assert/strict";
import { test } from "node:test";

import { createReader } from "./event_stream.js";

test("events are read from chunks of any size, and keep-alives are ignored", () => {
  const text = 'event: packet\ndata: {"at_s":1}\n\n:\n\nevent: lost\ndata: {"lost":3}\n\n';
  for (let at = 0; at <= text.length; at += 1) {
    const heard = [];
    const read = createReader((event, data) => heard.push([event, data]));
    read(text.slice(0, at));
    read(text.slice(at));
    assert.deepEqual(heard, [["packet", '{"at_s":1}'], ["lost", '{"lost":3}']]);
  }
});
