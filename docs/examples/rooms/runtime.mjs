// A runtime in another language: a model house with two rooms, for Onika's environment, console and page.
// Written after ../../protocol.md and ../../messages.md; plain Node 20, no packages.
//
//   node runtime.mjs TOKEN-FILE [PORT]
//
// It carries out the modules of house.mjs, under their names, by hand or as the tasks of an application; the code that
// an environment sends along is not looked at. What it cannot do it refuses with words.

import { randomBytes } from "node:crypto";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

import { MODULES, SIZE, Task } from "./house.mjs";
import { NOTHING, plain, serve } from "./link.mjs";
import { CHANGES, HANDLERS, refused } from "./requests.mjs";

const UNIT = "rt0";
const FASTEST_HZ = 100;
const LEASE_S = 1; // after so much silence a session holds nothing any more

/** A PlannedTask as the files of an environment would make it. */
const planned = (name) => {
  const ports = (kind) => MODULES[name].ports.filter((port) => port.kind === kind).map((port) => port.name);
  const [invar, outvar] = [ports("INVAR"), ports("OUTVAR")];
  const local = MODULES[name].locals.map(({ name, default: usual }) => [name, [String(usual)]]);
  const rest = { inconst: [], outconst: [], invar, outvar, aliases: [], local };
  return { name, module: name, digest: "", place: "", rtpu: UNIT, frequency: 20, type: "periodic", ...rest };
};

export class Runtime {
  constructor() {
    this.begun = performance.now();
    this.unit = UNIT;
    this.fastest = FASTEST_HZ;
    this.isStopped = false;
    this.subsystems = new Map(); // each { name, holder, run, tasks, table }, by name
    this.prepared = new Map(); // plans, by session
    this.edits = 0;
    this.attended = new Map(); // what sessions want to hear, by session
    this.shown = new Map(); // when they were shown readings last
    for (const name of Object.keys(MODULES)) this.spawn(this.subsystem("main"), planned(name));
  }

  get now() {
    return (performance.now() - this.begun) / 1000;
  }

  async listen(token, port = 0) {
    this.server = await serve({ port, token, runtime: this });
    this.timer = setInterval(() => this.turn(), 1000 / FASTEST_HZ);
    return this.server.port;
  }

  quit() {
    for (const subsystem of this.subsystems.values()) this.off(subsystem, [...subsystem.tasks.keys()]);
    clearInterval(this.timer);
    this.server.close();
  }

  // -- what is told

  /** An event for whoever attends to a subsystem; without one, for everybody. */
  tell(event, name, session) {
    for (const each of this.server?.sessions.values() ?? []) {
      const { subsystems = [] } = this.attended.get(each) ?? {};
      if (!name || each === session || subsystems.includes("*") || subsystems.includes(name)) each.tell(event);
    }
  }

  told(subsystem, event) {
    this.tell(
      { subsystem: subsystem.name, at_s: this.at(subsystem), ...event },
      subsystem.name,
      subsystem.run?.session,
    );
  }

  at(subsystem) {
    return subsystem.run ? this.now - subsystem.run.begun : this.now;
  }

  show() {
    for (const [session, { readings = [], hz = 10 }] of this.attended) {
      if (!session.isHere || this.now - (this.shown.get(session) ?? 0) < 1 / hz) continue;
      this.shown.set(session, this.now);
      for (const { name, table } of this.subsystems.values())
        for (const [variable, { value, count }] of table) {
          const key = `${name}/${variable}`;
          const now_ns = Math.round(this.now * 1e9);
          if (readings.includes(key) || readings.includes(`${name}/*`))
            session.show(key, { type: "Variable", now_ns, count, value });
        }
    }
  }

  company() {
    const event = { type: "Company", sessions: this.sessions() };
    for (const [session, { subsystems = [] }] of this.attended)
      if (subsystems.includes("@company") || subsystems.includes("*")) session.tell(event);
  }

  sessions() {
    const one = ({ name, isHere }) => ({ name, role: "owner", is_here: isHere, lease_s: LEASE_S });
    return [...this.server.sessions.values()].map(one);
  }

  // -- tasks and their subsystems

  subsystem(name) {
    if (!this.subsystems.has(name))
      this.subsystems.set(name, { name, holder: null, run: null, tasks: new Map(), table: new Map() });
    return this.subsystems.get(name);
  }

  spawn(subsystem, plan) {
    const task = new Task(plan);
    subsystem.tasks.set(plan.name, task);
    for (const kind of ["INVAR", "OUTVAR"])
      for (const [, name] of task.variables(kind))
        if (!subsystem.table.has(name)) subsystem.table.set(name, { value: Array(SIZE).fill(0), count: 0 });
    this.told(subsystem, { type: "TaskState", task: plan.name, state: "OFF" });
  }

  on(subsystem, name, line) {
    const task = subsystem.tasks.get(name);
    if (task.state === "ON") return;
    const level = task.module.input ? task.level(line) : 0;
    if (level === null) task.state = "ASKING";
    else task.start(subsystem.table, this.now, level);
    this.told(subsystem, { type: "TaskState", task: name, state: task.state });
    if (level === null) this.told(subsystem, this.question(task));
  }

  question({ plan, module: { input } }) {
    const { low, high, ...rest } = input;
    const item = { ...rest, default: null, low: [low], high: [high] };
    return { type: "Asked", task: plan.name, reason: plain(`how warm, from ${low} to ${high}?`), items: [item] };
  }

  off(subsystem, names) {
    for (const task of names.map((name) => subsystem.tasks.get(name)).filter(({ state }) => state !== "OFF")) {
      task.stop(subsystem.table);
      this.told(subsystem, { type: "TaskState", task: task.plan.name, state: "OFF" });
    }
  }

  kill(subsystem, names) {
    this.off(subsystem, names);
    for (const name of names) {
      subsystem.tasks.delete(name);
      this.told(subsystem, { type: "TaskState", task: name, state: "KILLED" });
    }
    const used = new Set([...subsystem.tasks.values()].flatMap((task) => ["INVAR", "OUTVAR"].flatMap((kind) => task.variables(kind).map(([, variable]) => variable)))); // prettier-ignore
    for (const name of subsystem.table.keys()) if (!used.has(name)) subsystem.table.delete(name);
  }

  /** What is wrong with tasks, as faults. */
  faults(tasks, subsystem = null) {
    const fault = (task, text) => ({
      file: task.place,
      line: 0,
      reason: plain(text),
      instead: plain("nothing is changed"),
    });
    const faults = [];
    const writers = new Map();
    for (const task of tasks) {
      if (!MODULES[task.module])
        faults.push(fault(task, `this runtime knows ${Object.keys(MODULES).join(", ")}, not ${task.module}`));
      else if (task.type !== "periodic" || !(task.frequency > 0 && task.frequency <= FASTEST_HZ))
        faults.push(fault(task, `${task.name} has to be periodic, with ${FASTEST_HZ} Hz at most`));
      if (subsystem?.tasks.has(task.name)) faults.push(fault(task, `${task.name} lives already`));
    }
    const living = [...(subsystem?.tasks.values() ?? [])].map(({ plan }) => plan);
    for (const task of [...living, ...tasks])
      for (const coded of task.outvar) {
        const variable = Object.fromEntries(task.aliases)[coded] ?? coded;
        if (writers.has(variable)) faults.push(fault(task, `${writers.get(variable)} writes ${variable} already`));
        writers.set(variable, task.name);
      }
    return faults;
  }

  /** One turn of the clock: every task that is due, what its finish leads to, and readings. */
  turn() {
    for (const subsystem of [...this.subsystems.values()])
      for (const [name, task] of [...subsystem.tasks]) {
        if (!task.cycle(subsystem.table, this.now)) continue;
        const { run } = subsystem;
        const [number, text] = [0, NOTHING];
        if (!run) this.told(subsystem, { type: "Signalled", task: name, kind: "FINISH", number, text });
        this.off(subsystem, [name]);
        if (run) run.finished(subsystem);
      }
    this.show();
  }

  // -- who holds what

  /** Why a session may not change a subsystem; it holds it from now on where it may. */
  hold(session, name) {
    const subsystem = this.subsystem(name);
    if (subsystem.holder && subsystem.holder !== session) return `${name} is held by ${subsystem.holder.name}`;
    if (!subsystem.holder) this.hand(subsystem, session);
    return "";
  }

  hand(subsystem, session, cause = NOTHING) {
    subsystem.holder = session;
    this.tell({ type: "Held", subsystem: subsystem.name, holder: session?.name ?? "", cause }, subsystem.name);
  }

  lost(session, why) {
    this.prepared.delete(session);
    for (const subsystem of [...this.subsystems.values()].filter(({ holder }) => holder === session)) {
      if (subsystem.run?.onLoss === "run") continue;
      if (subsystem.run) subsystem.run.end(plain(`${session.name} is gone: ${why}`));
      else this.off(subsystem, [...subsystem.tasks.keys()]);
      if (this.subsystems.has(subsystem.name)) this.hand(subsystem, null, plain(`${session.name} is gone: ${why}`));
    }
  }

  silent(session, seconds) {
    if (seconds > LEASE_S) this.lost(session, `it was silent for ${seconds.toFixed(1)} s`);
  }

  // -- requests

  answer(session, body, respond) {
    const handler = HANDLERS[body.type];
    const named = this.subsystems.get(body.subsystem);
    if (!handler) return respond(refused(`this runtime does not know ${body.type}`));
    if (CHANGES.has(body.type)) {
      const names =
        body.type === "Change" ? ["kill", "off"].flatMap((key) => body[key] ?? []) : [body.task ?? []].flat();
      const missing = names.filter((name) => !named?.tasks.has(name));
      if (!named && !["Change", "Take"].includes(body.type))
        return respond(refused(`there is no subsystem ${body.subsystem}`));
      if (missing.length) return respond(refused(`there is no task ${missing.join(", ")} in ${body.subsystem}`));
      if (named?.run && named.run.session !== session) return respond(refused("an application runs there"));
      const why = this.hold(session, body.subsystem);
      if (why) return respond(refused(why));
    }
    return handler.call(this, body, respond, session, this.subsystems.get(body.subsystem));
  }

  /** An edit that is accepted, carried out, and told. */
  edit(subsystem, respond, act) {
    const number = ++this.edits;
    respond({ type: "Accepted", number });
    act();
    this.told(subsystem, { type: "Edited", number, cause: NOTHING });
  }

  standing(subsystem) {
    const task = ({ plan, state, frequency }) => ({
      task: plan, state, is_wanted_on: state === "ON", rtpu: UNIT, frequency, reason: NOTHING,
    }); // prettier-ignore
    const tasks = [...subsystem.tasks.values()];
    const asking = tasks.filter(({ state }) => state === "ASKING");
    const asks = asking.map((each) => ({
      ...this.question(each),
      subsystem: subsystem.name,
      at_s: this.at(subsystem),
    }));
    const { name, holder, run } = subsystem;
    const rest = { application: run?.plan.application ?? "", on_loss: run?.onLoss ?? "" };
    return { name, holder: holder?.name ?? "", tasks: tasks.map(task), asks, ...rest };
  }

  values(subsystem, names = []) {
    const cells = [...subsystem.table].filter(([name]) => !names.length || names.includes(name));
    return Object.fromEntries(cells.map(([name, { value }]) => [name, value]));
  }
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const [, , tokenFile, port = "0"] = process.argv;
  if (!tokenFile) {
    console.error("expected: node runtime.mjs TOKEN-FILE [PORT]");
    process.exit(2);
  }
  if (!existsSync(tokenFile)) writeFileSync(tokenFile, randomBytes(24).toString("hex"), { mode: 0o600 });
  const runtime = new Runtime();
  const open = await runtime.listen(readFileSync(tokenFile, "utf8").trim(), Number(port));
  console.log(`rooms: listening on ws://127.0.0.1:${open}, token in ${tokenFile}`);
  for (const signal of ["SIGTERM", "SIGINT"]) process.on(signal, () => runtime.quit());
}
