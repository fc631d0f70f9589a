// An application that runs: each flow goes through its program, one action after the other.

import { NOTHING } from "./link.mjs";

const KNOWN = new Set(["Do", "Jump", "Halt"]);

/** The instructions of a plan that this runtime cannot carry out. */
export const strange = (plan) =>
  plan.flows.flatMap(({ program = [] }) => program.map(({ type }) => type).filter((type) => !KNOWN.has(type)));

/** One execution of an application. `plan` is a Plan, the options are those of Begin. */
export class Run {
  constructor(runtime, session, plan, { watch = [], settle_s = 0.5, on_loss = "stop" }) {
    Object.assign(this, { runtime, session, plan, watch, settle: settle_s, onLoss: on_loss });
    this.begun = runtime.now;
    this.name = plan.flows[0].subsystem;
    this.done = 0;
    this.flows = plan.flows.map((flow, number) => ({ flow, number, place: 0, index: -1, subsystem: this.open(flow) }));
    for (const each of this.flows) this.go(each);
  }

  open(flow) {
    const subsystem = this.runtime.subsystem(flow.subsystem);
    subsystem.run = this;
    this.runtime.hand(subsystem, this.session);
    this.moved(subsystem, "spawning", -1);
    for (const task of flow.tasks) this.runtime.spawn(subsystem, task);
    return subsystem;
  }

  moved(subsystem, state, action) {
    this.runtime.told(subsystem, { type: "Moved", state, action });
  }

  /** On to the next action of a flow, or to its end. */
  go(each) {
    const { flow, subsystem, number } = each;
    const program = flow.program.length ? flow.program : flow.actions.map((_, action) => ({ type: "Do", action }));
    while (program[each.place]?.type === "Jump") each.place = program[each.place].to;
    const next = program[each.place++];
    if (next?.type !== "Do") {
      this.moved(subsystem, "done", each.index);
      each.isDone = true;
      if (this.flows?.every(({ isDone }) => isDone)) setTimeout(() => this.end(NOTHING), this.settle * 1000);
      return;
    }
    const action = flow.actions[next.action];
    each.index = next.action;
    this.moved(subsystem, "running", each.index);
    const began = { flow: number, index: each.index, of: flow.actions.length, action: action.name, run: this.name };
    this.runtime.told(subsystem, { type: "Began", ...began });
    const others = [...subsystem.tasks.keys()].filter((name) => !action.tasks.includes(name));
    this.runtime.off(subsystem, others);
    for (const name of action.tasks)
      this.runtime.on(subsystem, name, subsystem.tasks.get(name).module.input ? action.arguments : "");
  }

  finished(subsystem) {
    const each = this.flows.find((flow) => flow.subsystem === subsystem);
    this.done += 1;
    this.runtime.told(subsystem, { type: "Done", flow: each.number, index: each.index, run: this.name });
    this.go(each);
  }

  end(cause) {
    if (this.isOver) return;
    this.isOver = true;
    const { runtime, session } = this;
    const read = this.watch.map((address) => {
      const [name, variable] = address.includes("/") ? address.split("/") : [this.name, address];
      return [address, runtime.subsystems.get(name)?.table.get(variable)?.value];
    });
    const seconds = runtime.now - this.begun;
    const figures = this.flows.flatMap(({ subsystem }) => [...subsystem.tasks.values()].map((task) => ({
      subsystem: subsystem.name, task: task.plan.name, rtpu: runtime.unit, hz: task.frequency, cycles: task.cycles,
      missed: 0, mean_us: 0, most_us: 0,
    }))); // prettier-ignore
    for (const { subsystem, index } of this.flows) {
      runtime.kill(subsystem, [...subsystem.tasks.keys()]);
      this.moved(subsystem, "ended", index);
    }
    const completed = cause === NOTHING;
    const of = this.flows.reduce((sum, { flow }) => sum + flow.actions.length, 0);
    const values = Object.fromEntries(read.filter(([, value]) => value));
    const times = { runtime_s: seconds, wall_s: seconds };
    const result = {
      type: "Result",
      completed,
      cause,
      done: this.done,
      of,
      ...times,
      values,
      tasks: figures,
      hash: "",
    };
    runtime.tell({ ...result, run: this.name }, this.name, session);
    for (const { subsystem } of this.flows) {
      runtime.subsystems.delete(subsystem.name);
      runtime.hand(subsystem, null);
    }
  }
}
