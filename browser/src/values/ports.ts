// What is known of a document's variables: their type and unit stand at the pins that use them.
import type { DocumentView, LocusView, PinView, TaskView } from '../api.gen'

export interface VariableRow {
  name: string
  type: string
  unit: string
  meaning: string
  locus: LocusView
}

/** All variables of a document by name. A writer's word on type and unit counts more than a reader's. */
export function variables(doc: DocumentView, tasks: Record<string, TaskView>): VariableRow[] {
  const pins = new Map<string, PinView>()
  for (const task of Object.keys(doc.tasks ?? {}))
    for (const pin of tasks[task]?.pins ?? []) {
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
