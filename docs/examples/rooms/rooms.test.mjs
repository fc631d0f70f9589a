// Tests of this runtime, by a client of its own: node --test

import assert from "node:assert/strict";
import { randomBytes } from "node:crypto";
import http from "node:http";
import { after, before, test } from "node:test";

import { pack, unpack } from "../msgpack.mjs";
import { Task } from "./house.mjs";
import { Runtime } from "./runtime.mjs";

const TOKEN = "open sesame";
const HEADERS = { Connection: "Upgrade", Upgrade: "websocket", "Sec-WebSocket-Version": "13" };
const runtime = new Runtime();
let port;

before(async () => (port = await runtime.listen(TOKEN)));
after(() => runtime.quit());

const frame = (payload) => {
  const mask = randomBytes(4);
  const head = Buffer.from([0x82, 0x80 | 126, payload.length >> 8, payload.length & 255]);
  return Buffer.concat([head, mask, payload.map((byte, index) => byte ^ mask[index & 3])]);
};

/** Opens a connection; resolves to the status of HTTP, or to a client that says packets and waits for them. */
function open({ token = TOKEN, path = "/", headers = {} } = {}) {
  const all = { ...HEADERS, "Sec-WebSocket-Key": randomBytes(16).toString("base64"), Authorization: `Bearer ${token}` };
  const request = http.request({ port, path, host: "127.0.0.1", headers: { ...all, ...headers } });
  return new Promise((resolve) => {
    request.on("response", (response) => resolve(response.resume().statusCode));
    request.on("upgrade", (_, socket, head) => resolve(client(socket, head)));
    request.end();
  });
}

function client(socket, head) {
  const came = [];
  const waiting = [];
  let rest = head;
  let asked = 0;
  const take = (data) => {
    rest = Buffer.concat([rest, data]);
    for (;;) {
      const short = rest.length < 2 ? 127 : rest[1];
      const begin = short === 126 ? 4 : 2;
      const length = short === 126 && rest.length >= 4 ? rest.readUInt16BE(2) : short;
      if (short === 127 || rest.length < begin + length) return;
      if ((rest[0] & 15) === 2) came.push(unpack(rest.subarray(begin, begin + length)));
      rest = rest.subarray(begin + length);
      for (const look of [...waiting]) look();
    }
  };
  socket.on("data", take);
  const say = (...packet) => socket.write(frame(pack(packet)));
  /** The first packet that a function says yes to, as soon as it is there. */
  const next = (wanted) =>
    new Promise((resolve) => {
      const look = () => {
        const place = came.findIndex(wanted);
        if (place < 0) return;
        waiting.splice(waiting.indexOf(look), 1);
        resolve(came.splice(place, 1)[0]);
      };
      waiting.push(look);
      look();
    });
  const ask = async (body, number = ++asked) => {
    say("request", number, number, 0, 0, pack(body));
    const [, , , , answer] = await next(([kind, to]) => kind === "reply" && to === number);
    return unpack(answer);
  };
  const event = async (wanted) => {
    const [, seq, body] = await next(([kind, , event]) => kind === "signal" && wanted(unpack(event)));
    say("ack", seq);
    return unpack(body);
  };
  const greet = async (name = "test", epoch = "", seq = 0) => {
    say("hello", 3, name, epoch, seq);
    const [, version, ...rest] = await next(([kind]) => kind === "welcome");
    assert.equal(version, 3);
    return rest;
  };
  return {
    say,
    next,
    ask,
    event,
    greet,
    end: () => socket.destroy(),
    say_bytes: (bytes) => socket.write(frame(bytes)),
  };
}

const takes = (name, ...rest) => ({
  name,
  module: name,
  type: "periodic",
  frequency: 100,
  aliases: [],
  local: [],
  ...rest,
});
const ports = {
  rooms: [["POWER"], ["WARMTH"]],
  thermostat: [["WARMTH", "WISH"], ["POWER"]],
  warm: [["WARMTH"], ["WISH"]],
};
const tasks = Object.entries(ports).map(([name, [invar, outvar]]) => ({
  name,
  module: name,
  type: "periodic",
  frequency: 100,
  aliases: [],
  local: [],
  place: "",
  invar,
  outvar,
}));

test("what is packed is the same when it is unpacked", () => {
  const value = { a: [0, 127, 128, -1, 2 ** 52, 0.5, null, true, "ä", Buffer.from([1])], b: {} };
  assert.deepEqual(unpack(pack(value)), value);
  assert.throws(() => unpack(pack(value).subarray(0, 9)));
});

test("a thermostat warms the house to what is wished", () => {
  const table = new Map(["POWER", "WARMTH", "WISH"].map((name) => [name, { value: [0, 0], count: 0 }]));
  table.get("WISH").value = [20, 18];
  const house = tasks.slice(0, 2).map((plan) => new Task(plan));
  for (const task of house) task.start(table, 0, 0);
  for (let turn = 0; turn < 2000; turn++) for (const task of house) task.cycle(table, turn / 100);
  const [left, right] = table.get("WARMTH").value;
  assert.ok(Math.abs(left - 20) < 0.2 && Math.abs(right - 18) < 0.2, `${left} ${right}`);
});

test("who has no token, or comes from a page of others, is not let in", async () => {
  assert.equal(await open({ token: "wrong" }), 401);
  assert.equal(await open({ path: "/other" }), 404);
  assert.equal(await open({ headers: { Origin: "http://elsewhere.example" } }), 403);
  assert.equal(await open({ headers: { Host: "elsewhere.example" } }), 403);
});

test("another version is told so, and garbage ends the connection", async () => {
  const old = await open();
  old.say("hello", 2, "old", "", 0);
  assert.deepEqual((await old.next(([kind]) => kind === "bye")).slice(1, 2), ["version"]);
  const garbage = await open();
  await garbage.greet("garbage");
  garbage.say_bytes(Buffer.from([0xc1, 0xff]));
  assert.equal((await garbage.next(([kind]) => kind === "bye"))[1], "garbage");
});

test("a request is carried out once, however often it is said", async () => {
  const here = await open();
  await here.greet("twice");
  const first = await here.ask({ type: "Change", subsystem: "twice", spawn: tasks }, 1);
  assert.equal(first.type, "Accepted");
  here.say("request", 1, 1, 0, 0, pack({ type: "Change", subsystem: "twice", spawn: tasks }));
  const again = await here.next(([kind, to]) => kind === "reply" && to === 1);
  assert.deepEqual(unpack(again[4]), first);
  here.say("request", 2, 2, 1, 0, pack({ type: "Close", subsystem: "twice" }));
  assert.equal((await here.next(([kind, to]) => kind === "reply" && to === 2))[2], true); // late
  here.say("bye", "closed", { key: "", text: "" });
});

test("signals that were missed follow on the next connection", async () => {
  const before = await open();
  const [epoch] = await before.greet("gone");
  await before.ask({ type: "Attend", subsystems: ["main"], readings: ["main/*"] });
  await before.ask({ type: "Stop", cause: { key: "", text: "" } });
  await before.next(([kind, , event]) => kind === "signal" && unpack(event).type === "Stopped"); // without an ack
  before.end();
  const behind = await open();
  const [same, seq, resumed] = await behind.greet("gone", epoch, 0);
  assert.deepEqual([same, seq, resumed], [epoch, 0, true]);
  assert.equal((await behind.event(({ type }) => type === "Stopped")).is_stopped, true);
  assert.equal((await behind.ask({ type: "Change", subsystem: "main", on: [{ task: "rooms" }] }, 3)).type, "Refused");
  assert.equal((await behind.ask({ type: "Reset" }, 4)).type, "Done");
  assert.equal((await behind.event(({ is_stopped }) => is_stopped === false)).type, "Stopped");
  behind.say("bye", "closed", { key: "", text: "" });
});

test("a session has three connections, and readings come on their own", async () => {
  const main = await open({ path: "/session" });
  const [epoch] = await main.greet("three");
  const signals = await open({ path: "/signal" });
  assert.equal((await signals.greet("three", epoch))[0], epoch);
  const stream = await open({ path: "/stream" });
  await stream.greet("three", epoch);
  await main.ask({ type: "Attend", subsystems: ["main"], readings: ["main/WARMTH"], hz: 50 });
  await main.ask({ type: "Change", subsystem: "main", on: [{ task: "rooms" }, { task: "thermostat" }] });
  assert.equal((await signals.event(({ type }) => type === "TaskState")).state, "ON");
  const [, , key, body] = await stream.next(([kind, , , body]) => kind === "reading" && unpack(body).value[0] > 0);
  assert.deepEqual([key, unpack(body).type], ["main/WARMTH", "Variable"]);
  main.say("bye", "closed", { key: "", text: "" });
  assert.equal((await signals.event(({ state }) => state === "OFF")).type, "TaskState"); // a lost holder's tasks go off
});

test("an application runs, one action after the other, and what it cannot do is refused with words", async () => {
  const here = await open();
  await here.greet("runner");
  const action = (name, level) => ({ name, tasks: Object.keys(ports), arguments: String(level) });
  const flow = { subsystem: "flow0", tasks, actions: [action("warm", 12), action("cool", 11)], program: [] };
  const plan = { application: "small", flows: [flow], code: [] };
  const meeting = { ...plan, flows: [{ ...flow, program: [{ type: "Meet", tag: "both" }] }] };
  const [fault] = (await here.ask({ type: "Prepare", plan: meeting })).faults;
  assert.match(fault.reason.text, /no Meet/);
  assert.deepEqual((await here.ask({ type: "Prepare", plan })).faults, []);
  assert.equal((await here.ask({ type: "Begin", watch: ["WARMTH"], settle_s: 0 })).type, "Done");
  assert.equal((await here.event(({ type }) => type === "Began")).action, "warm");
  assert.equal((await here.event(({ type }) => type === "Began")).action, "cool");
  const result = await here.event(({ type }) => type === "Result");
  assert.deepEqual([result.completed, result.done, result.of], [true, 2, 2]);
  assert.ok(Math.abs(result.values.WARMTH[0] - 11) < 0.5);
  assert.equal((await here.ask({ type: "Swap", subsystem: "main" })).type, "Refused");
});

test("a name that is not there yet is taken, and only its holder changes it", async () => {
  const here = await open();
  await here.greet("holder");
  assert.equal((await here.ask({ type: "Take", subsystem: "attic" })).type, "Done");
  const { you } = await here.ask({ type: "Sessions" });
  const attic = async () => (await here.ask({ type: "Survey" })).subsystems.find(({ name }) => name === "attic");
  assert.equal((await attic()).holder, you);
  const other = await open();
  await other.greet("other");
  assert.match((await other.ask({ type: "Take", subsystem: "attic" })).reason.text, /held by/);
  assert.equal((await here.ask({ type: "Release", subsystem: "attic" })).type, "Done");
  assert.equal(await attic(), undefined);
});

test("tasks of a holder who is not heard any more go off, and others may take them", async () => {
  const watcher = await open();
  await watcher.greet("watcher");
  await watcher.ask({ type: "Attend", subsystems: ["main"] });
  const holder = await open();
  await holder.greet("silent");
  await holder.ask({ type: "Change", subsystem: "main", on: [{ task: "thermostat" }] });
  assert.equal((await watcher.event(({ state }) => state === "ON")).task, "thermostat");
  assert.equal((await watcher.event(({ state }) => state === "OFF")).task, "thermostat"); // it says nothing: no beats
  assert.equal((await watcher.event(({ type, holder }) => type === "Held" && !holder)).subsystem, "main");
  assert.equal((await watcher.ask({ type: "Take", subsystem: "main" })).type, "Done");
});
