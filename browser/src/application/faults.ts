// What is wrong with single steps, what forbids a run before what is only worth knowing.
import type { ApplicationView, FaultView } from '../api.gen'
import { inReadingOrder } from './actions'

export const isFault = (fault: FaultView): boolean => (fault.level ?? 'fault') === 'fault'

/** All of an application as their steps are read; holes first, as what they lack makes others wrong. */
export function faultsOf(app: ApplicationView): FaultView[] {
  const all = Object.values(app.faults ?? {})
  const steps = inReadingOrder(
    app,
    all.map(({ step = 0 }) => step),
  )
  const places = new Map(steps.map((step, k) => [step, k]))
  const isHole = (step: number): boolean => app.steps?.[step]?.kind === 'hole'
  const placeOf = ({ step = 0 }: FaultView): number => (places.get(step) ?? -1) - (isHole(step) ? steps.length + 1 : 0)
  return all.sort((a, b) => placeOf(a) - placeOf(b))
}

const faultMaps = new WeakMap<object, ReadonlyMap<number, FaultView[]>>()

export function faultsAt(app: ApplicationView | undefined, step: number): FaultView[] {
  return app ? (faultsByStep(app).get(step) ?? []) : []
}

/** All that stand at a step, by it; sought once for all who ask, a thousand icons may have a fault each. */
export function faultsByStep(app: ApplicationView): ReadonlyMap<number, FaultView[]> {
  if (!app.faults) return new Map()
  const faultsOfSteps = faultMaps.get(app.faults) ?? sought(app)
  faultMaps.set(app.faults, faultsOfSteps)
  return faultsOfSteps
}

function sought(app: ApplicationView): ReadonlyMap<number, FaultView[]> {
  const faultsOfSteps = new Map<number, FaultView[]>()
  for (const fault of ordered(Object.values(app.faults ?? {}))) {
    if (!fault.step) continue
    const faults = faultsOfSteps.get(fault.step)
    if (faults) faults.push(fault)
    else faultsOfSteps.set(fault.step, [fault])
  }
  return faultsOfSteps
}

const ordered = (faults: FaultView[]): FaultView[] => [
  ...faults.filter(isFault),
  ...faults.filter((fault) => !isFault(fault)),
]
