// Watches a runtime: says hello, asks what there is, attends to everything and prints what happens.
// Plain Node 20, no packages. It uses one connection for everything (path "/"), see ../protocol.md.
//
//   node watch.mjs ws://127.0.0.1:7994 TOKEN-FILE [EVENTS]
//   node watch.mjs wss://robot.example:7994 TOKEN-FILE [EVENTS] [CA.pem]
//
// After so many EVENTS it says good-bye and ends; without the number it watches until it is stopped.

import { createHash, randomBytes } from "node:crypto";
import { readFileSync } from "node:fs";
import http from "node:http";
import https from "node:https";

import { pack, unpack } from "./msgpack.mjs";

const VERSION = 3;
const [, , url, tokenFile, limit = "Infinity", ca] = process.argv;
if (!tokenFile) {
  console.error("expected: node watch.mjs URL TOKEN-FILE [EVENTS] [CA.pem]");
  process.exit(2);
}

// -- WebSocket: one binary message for each packet

function frame(opcode, payload) {
  const mask = randomBytes(4);
  const long = payload.length > 65535;
  const head = Buffer.alloc(payload.length < 126 ? 2 : long ? 10 : 4);
  head[0] = 0x80 | opcode;
  head[1] = 0x80 | (payload.length < 126 ? payload.length : long ? 127 : 126);
  if (long) head.writeBigUInt64BE(BigInt(payload.length), 2);
  else if (payload.length >= 126) head.writeUInt16BE(payload.length, 2);
  return Buffer.concat([head, mask, payload.map((byte, index) => byte ^ mask[index & 3])]);
}

let rest = Buffer.alloc(0);
let message = [];

function* frames(data) {
  rest = Buffer.concat([rest, data]);
  while (rest.length >= 2) {
    const short = rest[1] & 127;
    const begin = short < 126 ? 2 : short === 126 ? 4 : 10;
    if (rest.length < begin) return;
    const length = short < 126 ? short : short === 126 ? rest.readUInt16BE(2) : Number(rest.readBigUInt64BE(2));
    if (rest.length < begin + length) return;
    yield { isLast: rest[0] >= 128, opcode: rest[0] & 15, payload: rest.subarray(begin, begin + length) };
    rest = rest.subarray(begin + length);
  }
}

// -- the link: hello, then requests; signals are acknowledged, beats kept up

const key = randomBytes(16).toString("base64");
const request = (url.startsWith("wss:") ? https : http).request(url.replace(/^ws/, "http"), {
  ca: ca && readFileSync(ca),
  headers: {
    Authorization: `Bearer ${readFileSync(tokenFile, "utf8").trim()}`,
    Connection: "Upgrade",
    Upgrade: "websocket",
    "Sec-WebSocket-Key": key,
    "Sec-WebSocket-Version": "13",
  },
});

request.on("response", (response) => {
  response.on("data", (text) => end(`refused (${response.statusCode}): ${text}`));
  response.on("end", () => end(`refused (${response.statusCode})`));
});
request.on("error", (error) => end(String(error)));
request.on("upgrade", (response, socket, head) => {
  const accept = createHash("sha1").update(`${key}258EAFA5-E914-47DA-95CA-C5AB0DC85B11`).digest("base64");
  if (response.headers["sec-websocket-accept"] !== accept) end("no WebSocket there");
  talk(socket, head);
});
request.end();

function talk(socket, head) {
  const say = (...packet) => socket.write(frame(2, pack(packet)));
  let asked = 0;
  let accepted = 0;
  let beats = 0;
  let left = Number(limit);
  // number, done_below: there is one request at a time, so all before it are settled
  const ask = (body) => say("request", ++asked, asked, 0, 0, pack(body));

  const hear = ([kind, ...said]) => {
    if (left <= 0) return;
    if (kind === "welcome") {
      console.log(`linked, epoch ${said[1]}`);
      accepted = said[2];
      setInterval(() => say("beat", ++beats, Math.round(performance.now() * 1e6)), 250);
      ask({ type: "Survey" });
    } else if (kind === "reply") {
      const body = unpack(said[3]);
      console.log(JSON.stringify(body));
      if (body.type === "Standing") ask({ type: "Attend", subsystems: ["*"] });
    } else if (kind === "signal" && said[0] === accepted + 1) {
      accepted = said[0];
      say("ack", accepted);
      console.log(JSON.stringify(unpack(said[1])));
      left -= 1;
    } else if (kind === "bye") {
      end(`the runtime ended the link: ${said[0]}, ${said[1].text ?? said[1]}`);
    }
    if (left <= 0) {
      say("bye", "closed", { key: "plain", text: "seen enough" });
      socket.end(frame(8, Buffer.from([0x03, 0xe8])), () => process.exit(0));
    }
  };

  const take = (data) => {
    for (const { isLast, opcode, payload } of frames(data)) {
      if (opcode === 9) socket.write(frame(10, Buffer.from(payload)));
      else if (opcode === 8) end("the connection was closed");
      else {
        message.push(Buffer.from(payload));
        if (isLast) hear(unpack(Buffer.concat(message.splice(0))));
      }
    }
  };

  socket.on("data", take);
  socket.on("close", () => end("the connection is gone"));
  socket.on("error", (error) => end(String(error)));
  say("hello", VERSION, randomBytes(16).toString("hex"), "", 0);
  take(head);
}

function end(why) {
  console.error(why.trim());
  process.exit(1);
}
