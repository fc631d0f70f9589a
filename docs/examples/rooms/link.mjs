// The runtime's end of the link: WebSocket, packets and sessions, as ../../protocol.md has them.
// Nothing here knows what a task is. Plain Node 20, no packages.

import { createHash, randomBytes } from "node:crypto";
import http from "node:http";

import { pack, unpack } from "../msgpack.mjs";

const VERSION = 3;
const PIECE = 65536; // bytes of a body that go in one packet
const LONGEST = 1 << 20; // bytes of a packet
const BODY = 64 << 20; // bytes of a body
const AHEAD = 256; // signals under way without an ack
const KEPT = 20000; // signals of a session
const BEAT_MS = 250;
const LOST_MS = 3000;
const FORGOTTEN_MS = 600_000;
const CARRIES = { "/": "all", "/session": "session", "/signal": "signal", "/stream": "stream" };
const MAY_SAY = {
  all: ["request", "part", "ack", "beat", "bye"],
  session: ["request", "part", "beat", "bye"],
  signal: ["ack", "beat", "bye"],
  stream: ["beat", "bye"],
};

/** A sentence of this runtime, which is in no catalogue. */
export const plain = (text) => ({ key: "plain", text });

export const NOTHING = { key: "", text: "" };

// -- WebSocket

function frame(opcode, payload) {
  const long = payload.length > 65535;
  const head = Buffer.alloc(payload.length < 126 ? 2 : long ? 10 : 4);
  head[0] = 0x80 | opcode;
  head[1] = payload.length < 126 ? payload.length : long ? 127 : 126;
  if (long) head.writeBigUInt64BE(BigInt(payload.length), 2);
  else if (payload.length >= 126) head.writeUInt16BE(payload.length, 2);
  return Buffer.concat([head, payload]);
}

/** Whole messages out of the bytes of a connection; `hear` gets each as `(opcode, payload)`. */
function framesTo(hear) {
  let rest = Buffer.alloc(0);
  let pieces = [];
  return (bytes) => {
    rest = Buffer.concat([rest, bytes]);
    while (rest.length >= 2) {
      const short = rest[1] & 127;
      const begin = (short < 126 ? 2 : short === 126 ? 4 : 10) + 4;
      if (rest.length < begin) return;
      const length = short < 126 ? short : short === 126 ? rest.readUInt16BE(2) : Number(rest.readBigUInt64BE(2));
      if (rest[1] < 128 || length > LONGEST) throw new Error("a frame without a mask, or too long");
      if (rest.length < begin + length) return;
      const mask = rest.subarray(begin - 4, begin);
      const payload = rest.subarray(begin, begin + length).map((byte, index) => byte ^ mask[index & 3]);
      const [isLast, opcode] = [rest[0] >= 128, rest[0] & 15];
      rest = rest.subarray(begin + length);
      if (opcode >= 8) hear(opcode, Buffer.from(payload));
      else {
        pieces.push(Buffer.from(payload));
        if (isLast) hear(2, Buffer.concat(pieces.splice(0)));
      }
    }
  };
}

// -- sessions: all that one client and this runtime have with each other, over one connection or three

class Session {
  constructor(client, order) {
    this.client = client;
    this.name = `owner#${order}`;
    this.epoch = randomBytes(8).toString("hex");
    this.connections = {}; // by what they carry
    this.seq = 0; // of the last signal
    this.signals = []; // those without an ack: [seq, body]
    this.sent = 0; // the last signal that went out on the present connection
    this.acked = 0;
    this.replies = new Map(); // what was answered, by the request's number; null: not yet
    this.settled = 1; // smaller numbers are settled
    this.pieces = new Map(); // of long requests
    this.readings = 0;
    this.heard = performance.now();
  }

  get isHere() {
    return Boolean(this.connections.all ?? this.connections.session);
  }

  tell(event) {
    this.signals.push([++this.seq, pack(event)]);
    if (this.signals.length > KEPT) this.signals.shift();
    this.flush();
  }

  flush() {
    const line = this.connections.all ?? this.connections.signal;
    if (!line) return;
    for (const [seq, body] of this.signals) {
      if (seq <= this.sent) continue;
      if (seq > this.acked + AHEAD) return;
      if (seq !== this.sent + 1) return line.bye("behind", "signals are gone that you did not accept");
      line.say("signal", seq, body);
      this.sent = seq;
    }
  }

  show(key, reading) {
    const line = this.connections.all ?? this.connections.stream;
    // who reads slowly misses readings, never signals
    if (line && line.socket.writableLength < PIECE) line.say("reading", ++this.readings, key, pack(reading));
  }

  reply(number, late, body) {
    this.replies.set(number, [late, body]);
    const line = this.connections.all ?? this.connections.session;
    if (!line) return;
    const count = Math.max(Math.ceil(body.length / PIECE) - 1, 0);
    for (let index = 0; index < count; index++)
      line.say("part", number, index, body.subarray(index * PIECE, (index + 1) * PIECE));
    line.say("reply", number, late, count, body.subarray(count * PIECE));
  }
}

/**
 * Serves sessions at 127.0.0.1. `runtime` has `answer(session, body, respond)`, `lost(session, why)` and
 * `company()`, called where somebody came or went. Resolves to the port, the sessions and `close`.
 */
export function serve({ port, token, runtime }) {
  const sessions = new Map(); // by the client's name
  const wrong = new Map(); // when wrong tokens came, by address
  let order = 0;
  const clock = () => Math.round(performance.now() * 1e6);

  function greet(line, [version, client, epoch, seq]) {
    if (version !== VERSION) return line.end("bye", "version", `this runtime speaks version ${VERSION}`);
    let session = sessions.get(client);
    const isFirst = line.carries === "all" || line.carries === "session";
    if (!isFirst && !session) return line.bye("refused", "there is no such session");
    if (isFirst && session && session.epoch !== epoch && session.settled + session.replies.size > 1) {
      lose(session, "its client began anew");
      sessions.delete(client);
      session = undefined;
    }
    const isNew = !session;
    session ??= new Session(client, ++order);
    sessions.set(client, session);
    const resumed = !isNew && session.epoch === epoch;
    session.connections[line.carries]?.close();
    session.connections[line.carries] = line;
    line.session = session;
    if (line.carries === "all" || line.carries === "signal") session.sent = resumed ? seq : session.seq;
    line.say("welcome", VERSION, session.epoch, resumed ? seq : session.seq, resumed, clock());
    session.flush();
    if (isFirst) runtime.company();
  }

  function hear(line, payload) {
    const [kind, ...said] = unpack(payload);
    line.heard = performance.now();
    const { session } = line;
    if (!session) {
      if (kind !== "hello" || said.length !== 4) throw new Error("no greeting");
      return greet(line, said);
    }
    if (!MAY_SAY[line.carries].includes(kind)) throw new Error(`${kind} has no place here`);
    if (line.carries === "all" || line.carries === "session") session.heard = line.heard;
    if (kind === "ack") {
      session.acked = Math.max(session.acked, said[0]);
      session.signals = session.signals.filter(([seq]) => seq > session.acked);
      session.flush();
    } else if (kind === "part") {
      const pieces = session.pieces.get(said[0]) ?? [];
      session.pieces.set(said[0], pieces);
      pieces[said[1]] = said[2];
      if (pieces.length * PIECE > BODY) throw new Error("a body that is too long");
    } else if (kind === "request") ask(session, ...said);
    else if (kind === "bye") {
      line.close();
      if (line.carries === "all" || line.carries === "session") lose(session, "it said good-bye");
    }
  }

  function ask(session, number, below, deadline, parts, last) {
    for (const done of session.replies.keys()) if (done < below) session.replies.delete(done);
    session.settled = Math.max(session.settled, below);
    const before = session.replies.get(number);
    if (before) return session.reply(number, ...before);
    if (before === null || number < session.settled) return;
    session.replies.set(number, null);
    const pieces = session.pieces.get(number) ?? [];
    session.pieces.delete(number);
    if (pieces.length !== parts) throw new Error("pieces are missing");
    if (deadline && clock() > deadline) return session.reply(number, true, Buffer.alloc(0));
    runtime.answer(session, unpack(Buffer.concat([...pieces, last])), (body) =>
      session.reply(number, false, pack(body)),
    );
  }

  function lose(session, why) {
    runtime.lost(session, why);
    runtime.company();
  }

  /** The reason to refuse a request of HTTP; nothing where it is let in. */
  function refusal({ headers, url, socket }) {
    const host = (headers.host ?? "").replace(/:\d+$/, "");
    if (!(url in CARRIES)) return [404, "no such path"];
    if (headers["sec-websocket-version"] !== "13" || !headers["sec-websocket-key"]) return [426, "a WebSocket, please"];
    if (!["127.0.0.1", "localhost"].includes(host)) return [403, `${host} is no name of this runtime`];
    if (headers.origin && headers.origin !== `http://${headers.host}`) return [403, "pages of others are not let in"];
    if (hash(headers.authorization ?? "").equals(hash(`Bearer ${token}`))) return null;
    const lately = (wrong.get(socket.remoteAddress) ?? []).filter((at) => performance.now() - at < 60_000);
    wrong.set(socket.remoteAddress, [...lately.slice(-10), performance.now()]);
    return lately.length >= 10 ? [429, "too many wrong tokens"] : [401, "the token is wrong or missing"];
  }

  function upgrade(request, socket, head) {
    socket.on("error", () => socket.destroy());
    const refused = refusal(request);
    if (refused) {
      const [status, text] = refused;
      const lines = [
        `Onika-Reason: ${JSON.stringify(plain(text))}`,
        `Content-Length: ${text.length}`,
        "Connection: close",
      ];
      return socket.end(`HTTP/1.1 ${status} ${http.STATUS_CODES[status]}\r\n${lines.join("\r\n")}\r\n\r\n${text}`);
    }
    const accept = createHash("sha1").update(
      `${request.headers["sec-websocket-key"]}258EAFA5-E914-47DA-95CA-C5AB0DC85B11`,
    );
    const lines = ["Upgrade: websocket", "Connection: Upgrade", `Sec-WebSocket-Accept: ${accept.digest("base64")}`];
    socket.write(`HTTP/1.1 101 Switching Protocols\r\n${lines.join("\r\n")}\r\n\r\n`);
    talk(socket, CARRIES[request.url], head);
  }

  function talk(socket, carries, head) {
    const line = {
      socket, carries, session: null, heard: performance.now(),
      say: (...packet) => socket.writable && socket.write(frame(2, pack(packet))),
      end: (...packet) => socket.end(Buffer.concat([frame(2, pack(packet)), frame(8, Buffer.from([0x03, 0xe8]))])),
      bye: (cause, text) => line.end("bye", cause, plain(text)),
      close: () => socket.end(frame(8, Buffer.from([0x03, 0xe8]))),
    }; // prettier-ignore
    let beats = 0;
    const timer = setInterval(() => {
      if (performance.now() - line.heard > LOST_MS) socket.destroy();
      else if (line.session) line.say("beat", ++beats, clock());
    }, BEAT_MS);
    const take = framesTo((opcode, payload) => {
      if (opcode === 9) socket.write(frame(10, payload));
      else if (opcode === 8) line.close();
      else if (opcode === 2) hear(line, payload);
    });
    const listen = (bytes) => {
      try {
        take(bytes);
      } catch (error) {
        line.bye("garbage", error.message);
      }
    };
    socket.setNoDelay(true);
    socket.on("data", listen);
    socket.on("close", () => {
      clearInterval(timer);
      if (line.session?.connections[line.carries] === line) delete line.session.connections[line.carries];
    });
    listen(head);
  }

  const watch = setInterval(() => {
    for (const session of sessions.values()) {
      const silence = performance.now() - session.heard;
      runtime.silent(session, silence / 1000);
      if (silence > FORGOTTEN_MS) sessions.delete(session.client);
    }
  }, BEAT_MS);

  const server = http.createServer((_, response) => response.writeHead(426).end("a WebSocket, please"));
  server.on("upgrade", upgrade);
  const close = () => {
    clearInterval(watch);
    for (const { connections } of sessions.values())
      for (const line of Object.values(connections)) line.bye("closed", "this runtime ends");
    server.close();
  };
  return new Promise((resolve) =>
    server.listen(port, "127.0.0.1", () => resolve({ port: server.address().port, sessions, close })),
  );
}

const hash = (text) => createHash("sha256").update(text).digest();
