// What is known of a document's variables: their type and unit stand at the pins that use them.
import type { LocusView, PinView, TaskView } from '../api.gen'

type SharedLocus = Pick<LocusView, 'line' | 'is_constant' | 'writers' | 'readers'>
/** A document, or a subsystem in which an application runs. */
export interface Shared {
  tasks?: Readonly<Record<string, unknown>>
  /** Its tasks that are otherwise than in the library. */
  own?: Readonly<Record<string, TaskView>>
  loci?: Readonly<Record<string, SharedLocus>>
}

export interface VariableRow {
  name: string
  type: string
  unit: string
  meaning: string
  locus: SharedLocus
}

/** All variables of a document by name. A writer's word on type and unit counts more than a reader's. */
export function variables(doc: Shared, tasks: Record<string, TaskView>): VariableRow[] {
  const pins = new Map<string, PinView>()
  for (const task of Object.keys(doc.tasks ?? {}))
    for (const pin of (doc.own?.[task] ?? tasks[task])?.pins ?? []) {
      const port = pins.get(pin.svar)
      if (!port || (!isOutput(port) && isOutput(pin))) pins.set(pin.svar, pin)
    }
  return Object.entries(doc.loci ?? {})
    .map(([name, locus]) => {
      const pin = pins.get(name)
      return { name, type: pin?.shape ?? '', unit: pin?.unit ?? '', meaning: pin?.meaning ?? '', locus }
    })
    .sort((a, b) => a.name.localeCompare(b.name))
}

const isOutput = (pin: PinView): boolean => pin.kind !== 'INCONST' && pin.kind !== 'INVAR'
