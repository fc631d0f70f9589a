// What is wrong with single steps, what forbids a run before what is only worth knowing.
import type { ApplicationView, FaultView } from '../api.gen'

export const isFault = (one: FaultView): boolean => (one.level ?? 'fault') === 'fault'

export function faultsAt(app: ApplicationView | undefined, step: number): FaultView[] {
  return ordered(Object.values(app?.faults ?? {}).filter((one) => one.step === step))
}

/** All that stand at a step, by it. */
export function faultsByStep(app: ApplicationView): Map<number, FaultView[]> {
  const found = new Map<number, FaultView[]>()
  for (const one of ordered(Object.values(app.faults ?? {}))) {
    if (!one.step) continue
    const known = found.get(one.step)
    if (known) known.push(one)
    else found.set(one.step, [one])
  }
  return found
}

const ordered = (faults: FaultView[]): FaultView[] => [...faults.filter(isFault), ...faults.filter((one) => !isFault(one))]
