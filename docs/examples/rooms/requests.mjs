// What is done for each request of ../../messages.md that this runtime knows.

import { MODULES, SIZE } from "./house.mjs";
import { NOTHING, plain } from "./link.mjs";
import { Run, strange } from "./run.mjs";

const DONE = { type: "Done" };
export const refused = (text) => ({ type: "Refused", reason: plain(text) });

/** Those that change a subsystem: who asks has to hold it, and does so from now on. */
export const CHANGES = new Set(["Change", "Reply", "Write", "Reinit", "Close", "Take"]);

/** What is done for each request: with its body, a function that takes the response, the session and the subsystem. */
export const HANDLERS = {
  Survey(_, respond) {
    const subsystems = [...this.subsystems.values()].map((each) => this.standing(each));
    const rtpus = [{ name: this.unit, is_lost: false, load: 0 }];
    const addresses = [`ws://127.0.0.1:${this.server.port}`];
    const { isStopped: is_stopped, now: now_s } = this;
    respond({ type: "Standing", subsystems, rtpus, worlds: [], is_virtual: false, is_stopped, now_s, addresses });
  },
  Status(_, respond) {
    const figure = (name) => (task) => ({
      subsystem: name, task: task.plan.name, rmod: task.plan.module, rtpu: this.unit, tid: 0, type: "P", crit: 0,
      state: task.state, cycle: task.cycles, miss: 0, ref_hz: task.frequency, mez_hz: task.frequency, ptime_s: 0,
      total_ms: 0, tick_ms: 0, least_use: 0, most_use: 0, mean_use: 0, least_ms: 0, most_ms: 0, mean_ms: 0, warn: 0,
    }); // prettier-ignore
    const tasks = [...this.subsystems.values()].flatMap(({ name, tasks }) => [...tasks.values()].map(figure(name)));
    respond({ type: "Figures", tasks, loads: { [this.unit]: 0 } });
  },
  Read({ names }, respond, _, subsystem) {
    const values = subsystem ? this.values(subsystem, names) : {};
    const types = Object.fromEntries(Object.keys(values).map((name) => [name, `double[${SIZE}]`]));
    respond({ type: "Values", values, now_s: this.now, types });
  },
  Attend(body, respond, session) {
    this.attended.set(session, body);
    respond(DONE);
  },
  Sessions(_, respond, session) {
    respond({ type: "Company", you: session.name, sessions: this.sessions() });
  },
  Check: (_, respond) => respond({ type: "Findings", findings: [] }),
  Snapshot: (_, respond) => respond({ type: "Worlds", snapshots: {} }),
  ListWorlds: (_, respond) => respond({ type: "WorldList", simulated: {} }),
  Who(_, respond) {
    const runs = new Set([...this.subsystems.values()].map(({ run }) => run).filter(Boolean));
    const place = ({ subsystem, index, isDone }) => ({
      subsystem: subsystem.name,
      state: isDone ? "done" : "running",
      action: index,
    });
    respond({ type: "Positions", flows: [...runs].flatMap(({ flows }) => flows.map(place)) });
  },
  Describe({ code }, respond) {
    const described = { type: "Described", sheets: {}, faults: {} };
    for (const { module, digest } of code) {
      const { ports, locals, input, isTrigger = false, doc } = MODULES[module] ?? {};
      const inputs = input ? [{ name: input.name, shape: input.type, unit: input.unit, meaning: input.meaning, low: input.low, high: input.high, default: null }] : []; // prettier-ignore
      if (doc)
        described.sheets[digest] = {
          ports,
          inputs,
          locals,
          trigger: isTrigger,
          passive: false,
          hardware: false,
          crit: 0,
          doc,
        };
      else described.faults[digest] = plain(`this runtime has no ${module}`);
    }
    respond(described);
  },
  Inspect({ tasks }, respond) {
    respond({ type: "Prepared", faults: this.faults(tasks) });
  },

  Stop({ cause }, respond) {
    this.isStopped = true;
    for (const subsystem of [...this.subsystems.values()]) {
      this.off(subsystem, [...subsystem.tasks.keys()]);
      subsystem.run?.end(cause);
    }
    this.tell({ type: "Stopped", is_stopped: true, cause });
    respond(DONE);
  },
  Reset(_, respond) {
    this.isStopped = false;
    this.tell({ type: "Stopped", is_stopped: false, cause: NOTHING });
    respond(DONE);
  },
  Quit(_, respond) {
    respond(DONE);
    setTimeout(() => this.quit(), 100);
  },

  Change({ kill = [], spawn = [], off = [], on = [], rates = [] }, respond, _, subsystem) {
    const rest = { tasks: new Map([...subsystem.tasks].filter(([name]) => !kill.includes(name))) };
    const faults = this.faults(spawn, rest);
    if (faults.length) return respond({ type: "Prepared", faults });
    const there = new Set([...rest.tasks.keys(), ...spawn.map(({ name }) => name)]);
    const missing = [...on.map(({ task }) => task), ...rates.map(([task]) => task)].filter((name) => !there.has(name));
    if (missing.length) return respond(refused(`there is no task ${missing.join(", ")} in ${subsystem.name}`));
    if (on.length && this.isStopped) return respond(refused("everything is stopped; reset it first"));
    if (rates.some(([, hz]) => !(hz > 0 && hz <= this.fastest)))
      return respond(refused(`a rate is ${this.fastest} Hz at most`));
    this.edit(subsystem, respond, () => {
      this.kill(subsystem, kill);
      for (const plan of spawn) this.spawn(subsystem, plan);
      for (const [name, hz] of rates) subsystem.tasks.get(name).frequency = hz;
      this.off(subsystem, off);
      for (const { task, arguments: line = "" } of on) this.on(subsystem, task, line);
    });
  },
  Reply({ task, line }, respond, _, subsystem) {
    const asking = subsystem.tasks.get(task);
    if (asking.state !== "ASKING") return respond(refused(`${task} asks nothing`));
    if (asking.level(line) === null) return respond(refused("expected a number of degrees that the house can have"));
    respond(DONE);
    this.on(subsystem, task, line);
  },
  Write({ name, values }, respond, _, subsystem) {
    const cell = subsystem.table.get(name);
    const writes = (task) => task.variables("OUTVAR").some(([, variable]) => variable === name);
    if (!cell || values.length !== SIZE) return respond(refused(`there is no ${name} of ${values.length} elements`));
    const writer = [...subsystem.tasks.values()].find(writes);
    if (writer) return respond(refused(`${writer.plan.name} writes ${name}`));
    Object.assign(cell, { value: values, count: cell.count + 1 });
    respond(DONE);
  },
  Reinit({ task, local }, respond, _, subsystem) {
    if (subsystem.tasks.get(task).state !== "OFF") return respond(refused(`${task} is not OFF`));
    const one = subsystem.tasks.get(task);
    this.edit(subsystem, respond, () => one.renew((one.plan = { ...one.plan, local: local ?? one.plan.local }).local));
  },
  Close(_, respond, __, subsystem) {
    this.edit(subsystem, respond, () => this.kill(subsystem, [...subsystem.tasks.keys()]));
    this.subsystems.delete(subsystem.name);
  },
  Take: (_, respond) => respond(DONE),
  Release({ subsystem }, respond, session) {
    const held = this.subsystems.get(subsystem);
    if (held?.holder !== session) return respond(refused(`you do not hold ${subsystem}`));
    this.hand(held, null);
    if (!held.tasks.size) this.subsystems.delete(subsystem);
    respond(DONE);
  },

  Prepare({ plan }, respond, session) {
    const faults = plan.flows.flatMap(({ tasks }) => this.faults(tasks));
    const fault = (text) =>
      faults.push({ file: plan.application, line: 0, reason: plain(text), instead: plain("nothing moves") });
    for (const { subsystem } of plan.flows)
      if (this.subsystems.get(subsystem)?.tasks.size) fault(`${subsystem} is not empty`);
    const cannot = strange(plan);
    if (cannot.length) fault(`this runtime carries out actions one after the other, no ${cannot.join(", ")}`);
    if (!faults.length) this.prepared.set(session, plan);
    respond({ type: "Prepared", faults });
  },
  Begin(body, respond, session) {
    const plan = this.prepared.get(session);
    if (!plan) return respond(refused("nothing is prepared"));
    if (this.isStopped) return respond(refused("everything is stopped; reset it first"));
    if (body.record || body.is_held || body.on_loss === "finish")
      return respond(refused("this runtime records nothing, has no held clock and knows no pause"));
    this.prepared.delete(session);
    respond(DONE);
    new Run(this, session, plan, body);
  },
  Abort({ cause, subsystem = "" }, respond, session) {
    const runs = new Set([...this.subsystems.values()].map(({ run }) => run).filter((run) => run?.session === session));
    const meant = [...runs].filter(({ name }) => !subsystem || name === subsystem);
    if (!meant.length) return respond(refused("nothing runs that you may end"));
    respond(DONE);
    for (const run of meant) run.end(cause);
  },
};
