// Tells the flows of one application: each action, hole, branch and loop in a sentence (X11).
import type { ApplicationView, StepView, TypeView } from '../api.gen'
import { goesOn, isLong } from './joining'
import { compose, glue, type Part, plain } from './phrase'
import { inWords } from './relation'
import { type Connectives, fillOne, note, type Sentence } from './tale'

/** An action and what belongs to it, or a hole, a stray target or a branch by itself. */
interface Group {
  step: number
  view: StepView
  /** Its targets and the holes for them. */
  rest: readonly number[]
}

/** A loop of a flow, by the places of its two ends among the groups. */
interface Loop {
  tag: string
  from: number
  to: number
  test: number
}

export class Teller {
  /** The actions counted so far: numbers go on through branches. */
  private count = 0
  private readonly numbers: Intl.NumberFormat

  constructor(
    private readonly app: ApplicationView,
    private readonly types: Readonly<Record<string, TypeView>>,
    private readonly connectives: Connectives,
    private readonly tops: readonly string[],
  ) {
    this.numbers = new Intl.NumberFormat(connectives.code, { maximumFractionDigits: 3, useGrouping: false })
  }

  flow(path: string, depth: number): Sentence[] {
    const groups = this.groups(path)
    const loops = loopsOf(groups)
    const numbers: number[] = []
    return groups.flatMap((group, at) => {
      if (group.view.kind === 'branch') {
        numbers.push(this.count)
        return this.branch(group, depth)
      }
      if (isAction(group.view)) this.count += 1
      numbers.push(this.count)
      return [this.group(group, path, depth), ...this.looped(loops, at, groups, numbers, depth)]
    })
  }

  briefs(): Map<number, string> {
    const groups = Object.keys(this.app.flows ?? {}).flatMap((path) => this.groups(path))
    return new Map(
      groups.flatMap(({ step, view, rest }) => {
        const text = view.kind === 'branch' ? '' : plain(this.core(view, rest, false))
        return [step, ...rest].map((number) => [number, text] as const)
      }),
    )
  }

  private groups(path: string): Group[] {
    const ways: { step: number; view: StepView; rest: number[] }[] = []
    for (const step of this.app.flows?.[path]?.steps ?? []) {
      const view = this.app.steps?.[step]
      if (!view) continue
      const last = ways.at(-1)
      if (view.is_joined && last && last.view.kind !== 'branch') last.rest.push(step)
      else ways.push({ step, view, rest: [] })
    }
    return ways
  }

  private group({ step, view, rest }: Group, path: string, depth: number): Sentence {
    const common = { step, steps: [step, ...rest], depth }
    if (view.kind === 'hole') return { ...common, kind: 'hole', number: 0, parts: this.ended([this.hole(view)]) }
    if (!isAction(view))
      return {
        ...common,
        kind: 'hole',
        number: 0,
        parts: this.ended(compose(this.connectives.say('say.stray'), { target: [this.name(view)] })),
      }
    const has = rest.some((number) => this.app.steps?.[number]?.kind === 'hole')
    return {
      ...common,
      kind: has ? 'hole' : 'action',
      number: this.count,
      parts: this.ended(this.action(view, rest, path)),
    }
  }

  /** Prefix, what is done, suffix. */
  private action(view: StepView, rest: readonly number[], path: string): Part[] {
    let core = this.core(view, rest)
    if (view.role === 'application' && view.name)
      core = compose(this.connectives.say('say.nested'), { what: core, name: glue(view.name) })
    if (view.synch_tag && this.app.is_parallel) core = this.together(core, view.synch_tag, path)
    if (!view.breaks) return core
    const pause = view.break_if
      ? compose(this.connectives.say('say.pauseIf'), { condition: glue(this.condition(view.break_if)) })
      : glue(this.connectives.say('say.pause'))
    return [...core, { text: ', ' }, ...pause.map((part) => ({ ...part, kind: 'mark' as const }))]
  }

  private core(view: StepView, rest: readonly number[], isTimed = true): Part[] {
    const job = this.words(view)
    const targets = rest
      .flatMap((number) => this.app.steps?.[number] ?? [])
      .map((view) => (view.kind === 'hole' ? [this.hole(view, true)] : isTimed ? this.target(view) : [this.name(view)]))
    if (!targets.length) return glue(job)
    const joined = targets.flatMap((target, k) => (k ? [{ text: this.connectives.say('say.and') }, ...target] : target))
    const isOpen =
      goesOn(this.connectives.code, job, joined[0]?.text ?? '') && !joined.some((part) => part.kind === 'fault')
    return [{ text: isOpen ? `${job} ` : `${job}: ` }, ...joined]
  }

  /** A target's words, and how long it may take. */
  private target(view: StepView): Part[] {
    const items = this.types[view.type ?? '']?.items ?? []
    const at = items.findIndex((item) => item.name === 'duration')
    const seconds = Number(view.values?.[at]?.[0])
    const isWhole = items.length === 1 && !!this.description(view) // it speaks of nothing else
    const name = this.name(view)
    if (at < 0 || isWhole || !Number.isFinite(seconds)) return [name]
    return compose(this.connectives.say(isLong(name.text) ? 'say.takesComma' : 'say.takes'), {
      target: [name],
      seconds: glue(this.number(seconds)),
    })
  }

  private together(core: Part[], tag: string, path: string): Part[] {
    const own = path.split('/')[0]
    const others = this.tops.filter((top) => top !== own && this.hasTag(top, tag))
    const list = new Intl.ListFormat(this.connectives.code).format(
      others.map((top) => fillOne(this.connectives.say('say.flow'), top).toLowerCase()),
    )
    const template = this.connectives.say(others.length ? 'say.together' : 'say.alone')
    return compose(template, { others: glue(list), tag: [{ text: tag, kind: 'mark' }], what: core })
  }

  private hasTag(top: string, tag: string): boolean {
    return Object.entries(this.app.flows ?? {}).some(
      ([path, flow]) =>
        path.split('/')[0] === top && (flow.steps ?? []).some((step) => this.app.steps?.[step]?.synch_tag === tag),
    )
  }

  private hole(view: StepView, isInside = false): Part {
    const kinds = (view.wants ?? []).map((type) => type.replace(/\s+object$/i, ''))
    if (!kinds.length) return { text: this.connectives.say('say.missingAction'), kind: 'fault' }
    const list = new Intl.ListFormat(this.connectives.code, { type: 'disjunction' }).format(kinds)
    const text = fillType(
      this.connectives.say(/^[aeio]/i.test(list) ? 'say.missingTargetAn' : 'say.missingTarget'),
      list,
    )
    return { text: isInside ? text : capital(text), kind: 'fault' }
  }

  private branch({ step, view }: Group, depth: number): Sentence[] {
    const conditions = view.conditions ?? []
    return (view.flows ?? []).flatMap((path, k) => {
      const parts = this.caseOf(conditions, k)
      const inner = this.flow(path, depth + 1)
      if (!inner.length) inner.push(note(this.connectives.say('say.nothing'), depth + 1))
      return [{ kind: 'case', step, steps: [step], number: 0, depth, parts } as const, ...inner]
    })
  }

  private caseOf(conditions: readonly string[], k: number): Part[] {
    if (!conditions.length) return glue(fillOne(this.connectives.say('say.way'), String(k)))
    const condition = conditions[k]
    if (condition === undefined) return glue(this.connectives.say('say.else'))
    return compose(this.connectives.say(k ? 'say.elseIf' : 'say.if'), { condition: glue(this.condition(condition)) })
  }

  /** What is said behind a group about the loops that end, or are asked, there. */
  private looped(
    loops: readonly Loop[],
    at: number,
    groups: readonly Group[],
    numbers: readonly number[],
    depth: number,
  ): Sentence[] {
    const tag = groups[at]?.view.loop
    const broken = tag && !loops.some((loop) => loop.tag === tag)
    if (broken)
      return [
        this.loopSentence(
          groups[at]!,
          compose(this.connectives.say('say.loopBroken'), { tag: [{ text: tag, kind: 'mark' }] }),
          depth,
        ),
      ]
    return loops
      .filter((loop) => (loop.test === loop.from ? loop.from : loop.to) === at)
      .map((loop) => {
        const test = groups[loop.test]!
        const isTop = loop.test === loop.from
        const values = {
          from: glue(String(isTop ? numbers[at] : numbers[loop.from])),
          to: glue(String(isTop ? numbers[at]! + this.actionsBetween(groups, at, loop.to) : numbers[loop.to])),
          condition: glue(
            test.view.loop_if
              ? this.condition(test.view.loop_if)
              : fillOne(this.connectives.say('say.saysSo'), String(numbers[loop.test])),
          ),
          tag: [{ text: loop.tag, kind: 'mark' as const }],
        }
        return this.loopSentence(
          test,
          compose(this.connectives.say(isTop ? 'say.loopTop' : 'say.loopBottom'), values),
          depth,
        )
      })
  }

  private loopSentence({ step }: Group, parts: Part[], depth: number): Sentence {
    return { kind: 'loop', step, steps: [], number: 0, depth, parts: this.ended(parts) }
  }

  /** How many actions are counted behind one group up to another, those in branches too. */
  private actionsBetween(groups: readonly Group[], from: number, to: number): number {
    return groups.slice(from + 1, to + 1).reduce((sum, { view }) => sum + this.actionsOf(view), 0)
  }

  private actionsOf(view: StepView): number {
    if (view.kind !== 'branch') return isAction(view) ? 1 : 0
    return (view.flows ?? []).reduce(
      (sum, path) => sum + this.groups(path).reduce((inner, group) => inner + this.actionsOf(group.view), 0),
      0,
    )
  }

  private condition(text: string): string {
    return inWords(
      text,
      (key) => this.connectives.say(key),
      (value) => this.number(value),
    )
  }

  private number(value: number): string {
    return this.numbers.format(value)
  }

  private name(view: StepView): Part {
    return { text: this.words(view), kind: 'target' }
  }

  private words(view: StepView): string {
    return this.description(view) || view.name || this.connectives.say('say.nameless')
  }

  private description(view: StepView): string {
    return (view.words?.[this.connectives.code] ?? view.description ?? '').trim().replace(/\.$/, '')
  }

  /** With a capital and a full stop. */
  private ended(parts: Part[]): Part[] {
    const [first, ...others] = parts
    if (!first) return []
    const end = /[.!?:]$/.test(plain(parts)) ? [] : [{ text: '.' }]
    return [{ ...first, text: capital(first.text) }, ...others, ...end]
  }
}

function loopsOf(groups: readonly Group[]): Loop[] {
  const ends = new Map<string, number[]>()
  groups.forEach(({ view }, at) => {
    if (view.loop) ends.set(view.loop, [...(ends.get(view.loop) ?? []), at])
  })
  return [...ends].flatMap(([tag, [from, to, ...more]]) => {
    if (from === undefined || to === undefined || more.length) return []
    const tests = [from, to].filter((at) => groups[at]!.view.is_test)
    return tests.length === 1 ? [{ tag, from, to, test: tests[0]! }] : []
  })
}

const isAction = (view: StepView): boolean => (view.kind ?? 'icon') === 'icon' && view.role !== 'target'
const capital = (text: string): string => text.charAt(0).toLocaleUpperCase() + text.slice(1)
const fillType = (text: string, type: string): string => text.replaceAll('{type}', type)
