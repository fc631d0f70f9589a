// A model house with two heated rooms: what the tasks of this runtime do. Nothing here knows of a connection.
//
// A module declares its ports as Onika's own modules do and makes the state of one task. `cycle` gets the values of its
// INVARs by their coded names and the seconds since the last cycle, and returns the values of its OUTVARs; `finished`
// beside them is the FINISH of a trigger. What `on` and `off` return is written too.

const OUTSIDE = 10; // degrees
const CAPACITY = 10; // joules a degree: a house of cardboard
const LOSS = 2; // watts a degree, to the outside
const WALL = 1; // watts a degree, from room to room
const MOST = 60; // watts of one heater

const port = (kind, name, unit, meaning) => ({ kind, name, shape: "double[2]", unit, meaning });
const local = (name, unit, meaning, value, low) => ({ name, shape: "double", unit, meaning, default: value, low });

export const MODULES = {
  rooms: {
    doc: "Two rooms of a model house, warmed by their heaters and cooled by the weather.",
    ports: [
      port("INVAR", "POWER", "W", "of the heater of each room"),
      port("OUTVAR", "WARMTH", "degC", "of each room"),
    ],
    locals: [],
    make: () => {
      let warmth = [OUTSIDE, OUTSIDE];
      return {
        on: () => ({ WARMTH: warmth }),
        cycle: ({ POWER }, dt) => {
          const [left, right] = warmth;
          const flows = [WALL * (right - left), WALL * (left - right)];
          const heat = warmth.map((here, room) => POWER[room] + flows[room] - LOSS * (here - OUTSIDE));
          warmth = warmth.map((here, room) => here + (heat[room] * dt) / CAPACITY);
          return { WARMTH: warmth };
        },
        off: () => ({}),
      };
    },
  },

  thermostat: {
    doc: "Heats each room as far as it is colder than wished.",
    ports: [
      port("INVAR", "WARMTH", "degC", "of each room"),
      port("INVAR", "WISH", "degC", "how warm each room shall be"),
      port("OUTVAR", "POWER", "W", "of the heater of each room"),
    ],
    locals: [local("GAIN", "W", "power for each degree that is missing", 40, 0)],
    make: ({ GAIN }) => ({
      on: () => ({}),
      cycle: ({ WARMTH, WISH }) => {
        const wanted = WARMTH.map((here, room) => LOSS * (WISH[room] - OUTSIDE) + GAIN * (WISH[room] - here));
        return { POWER: wanted.map((power) => Math.min(Math.max(power, 0), MOST)) };
      },
      off: () => ({ POWER: [0, 0] }), // nobody heats a house that nobody measures
    }),
  },

  warm: {
    doc: "Wishes one warmth of both rooms, and finishes when both have it to half a degree.",
    isTrigger: true,
    input: {
      name: "level",
      type: "double",
      count: 1,
      unit: "degC",
      meaning: "how warm both rooms shall be",
      low: 5,
      high: 30,
    },
    ports: [
      port("INVAR", "WARMTH", "degC", "of each room"),
      port("OUTVAR", "WISH", "degC", "how warm each room shall be"),
    ],
    locals: [],
    make: () => {
      let wish = [OUTSIDE, OUTSIDE];
      return {
        on: (level) => ({ WISH: (wish = [level, level]) }),
        cycle: ({ WARMTH }) => ({
          WISH: wish,
          finished: WARMTH.every((here, room) => Math.abs(here - wish[room]) < 0.5),
        }),
        off: () => ({}),
      };
    },
  },
};

export const SIZE = 2; // every variable here is double[2], one number for each room

/** A task of one subsystem: a module, its names for variables, and where it stands in its life. */
export class Task {
  /** `plan` is a PlannedTask of the protocol. */
  constructor(plan) {
    this.plan = plan;
    this.module = MODULES[plan.module];
    this.frequency = plan.frequency;
    this.state = "OFF";
    this.cycles = 0;
    this.aliases = Object.fromEntries(plan.aliases);
    this.renew(plan.local);
  }

  renew(lines) {
    const words = Object.fromEntries(lines);
    const values = this.module.locals.map(({ name, default: usual }) => [name, Number(words[name]?.[0] ?? usual)]);
    this.work = this.module.make(Object.fromEntries(values));
  }

  variable(coded) {
    return this.aliases[coded] ?? coded;
  }

  variables(kind) {
    return this.module.ports.filter((each) => each.kind === kind).map(({ name }) => [name, this.variable(name)]);
  }

  /** The number that an argument line gives; nothing where there is none, or it is out of bounds. */
  level(line) {
    const { input } = this.module;
    const number = line.trim() === "" ? NaN : Number(line);
    return number >= input.low && number <= input.high ? number : null;
  }

  start(table, now, level) {
    this.write(table, this.work.on(level));
    this.state = "ON";
    this.next = now;
  }

  stop(table) {
    if (this.state === "ON") this.write(table, this.work.off());
    this.state = "OFF";
  }

  /** One cycle if it is due; whether it has finished its job. */
  cycle(table, now) {
    if (this.state !== "ON" || now < this.next) return false;
    const dt = 1 / this.frequency;
    this.next = Math.max(this.next + dt, now - dt);
    this.cycles += 1;
    const inputs = this.variables("INVAR").map(([coded, name]) => [coded, table.get(name).value]);
    const { finished = false, ...outputs } = this.work.cycle(Object.fromEntries(inputs), dt);
    this.write(table, outputs);
    return finished;
  }

  write(table, outputs) {
    for (const [coded, value] of Object.entries(outputs)) {
      const cell = table.get(this.variable(coded));
      Object.assign(cell, { value, count: cell.count + 1 });
    }
  }
}
