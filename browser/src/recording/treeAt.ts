// The tree as it was at an instant of a recorded run: whoever draws it needs not know. Nothing of the present is mixed in:
// what the recording does not tell is not shown.
import type {
  ApplicationView,
  DocumentView,
  InstantView,
  LocusView,
  PlacedView,
  RedirectView,
  RuntimeView,
  StepView,
  LivingTaskView,
  SubsystemView,
} from '../api.gen'
import type { FullTree } from '../link/desk.svelte'
import { MARK } from '../widgets/mark'

export interface Then {
  /** Undefined before the first answer. */
  instant: InstantView | undefined
  worlds: readonly string[]
  /** The application whose run it was, and who stood for whom in it. */
  doc?: string
  redirects?: readonly RedirectView[]
  /** What lived in its subsystems. */
  inside?: Readonly<Record<string, SubsystemView>>
}

/** Makes the tree as it was at an instant; what it reads of `then` is what the drawing follows. */
export function treeAt(then: () => Then): (live: FullTree) => FullTree {
  const kept = new WeakMap<object, object>()

  /** The same thing with some of its values exchanged; of one thing always the same one, so that nothing is drawn anew for it. */
  function over<T extends object>(thing: T, exchanged: (name: string, value: unknown) => unknown): T {
    const before = kept.get(thing)
    if (before) return before as T
    const made = new Proxy(thing, {
      get: (original, name) =>
        typeof name === 'string' ? exchanged(name, Reflect.get(original, name)) : Reflect.get(original, name),
    })
    kept.set(thing, made)
    return made
  }

  const each = <T extends object>(all: Record<string, T>, seen: (thing: T, name: string) => T): Record<string, T> =>
    over(all, (name, value) => (value && typeof value === 'object' ? seen(value as T, name) : value))

  const homeOf = (doc: string): string => then().instant?.homes?.[doc] ?? ''
  const stateWithin = (home: string, task: string): NonNullable<PlacedView['state']> => {
    const state = (home && then().instant?.tasks?.[`${home}/${task}`]) || ''
    return (state in MARK ? state : '') as NonNullable<PlacedView['state']> // in any other it did not live
  }
  const stateIn = (doc: string, task: string): PlacedView['state'] => stateWithin(homeOf(doc), task)

  const placed = (view: PlacedView, doc: string, task: string): PlacedView =>
    over(view, (name, value) => {
      if (name === 'state') return stateIn(doc, task)
      return ['error', 'ask', 'note'].includes(name) ? undefined : value
    })

  /** Who supplies a variable then, by the states of those who write it. */
  const locus = (view: LocusView, doc: string): LocusView =>
    over(view, (name, value) => {
      if (name !== 'line') return value
      const states = (view.writers ?? []).map((task) => stateIn(doc, task))
      return states.includes('ON') ? 'live' : states.includes('ERROR') ? 'stale' : 'idle'
    })

  const document = (view: DocumentView, doc: string): DocumentView =>
    over(view, (name, value) => {
      if (name === 'connection') return homeOf(doc) ? 'live' : 'none'
      if (name === 'subsystem') return homeOf(doc)
      if (name === 'application' || name === 'recording') return ''
      if (name === 'tasks' && value)
        return each(value as Record<string, PlacedView>, (task, its) => placed(task, doc, its))
      if (name === 'loci' && value) return each(value as Record<string, LocusView>, (dot) => locus(dot, doc))
      return value
    })

  /** What was found when it was looked at since, and who stands for whom now, is no part of that run. */
  const step = (view: StepView): StepView => over(view, (name, value) => (name === 'note' ? undefined : value))
  const application = (view: ApplicationView, doc: string): ApplicationView =>
    over(view, (name, value) => {
      if (doc !== then().doc) return value
      if (name === 'redirects') return then().redirects ?? []
      return name === 'steps' && value ? each(value as Record<string, StepView>, step) : value
    })

  const living = (view: LivingTaskView, home: string, task: string): LivingTaskView =>
    over(view, (name, value) => (name === 'state' ? stateWithin(home, task) : value))
  const subsystem = (view: SubsystemView, home: string): SubsystemView =>
    over(view, (name, value) =>
      name === 'tasks' && value
        ? each(value as Record<string, LivingTaskView>, (task, its) => living(task, home, its))
        : value,
    )

  const runtime = (view: RuntimeView): RuntimeView =>
    over(view, (name, value) =>
      name === 'worlds'
        ? Object.fromEntries(then().worlds.map((world) => [world, true]))
        : name === 'units' || name === 'world_kinds'
          ? {}
          : name === 'inside'
            ? each({ ...then().inside }, subsystem)
            : value,
    )

  return (live) =>
    over(live, (name, value) => {
      if (name === 'run') return then().instant?.run ?? null
      if (name === 'beside') return {}
      if (name === 'documents') return each(value as Record<string, DocumentView>, document)
      if (name === 'applications') return each(value as Record<string, ApplicationView>, application)
      return name === 'runtime' ? runtime(value as RuntimeView) : value
    })
}
