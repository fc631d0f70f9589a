import { expect, it } from 'vitest'
import type { DocumentView, TaskView } from '../../src/api.gen'
import { variables } from '../../src/values/ports'

const task = (name: string, pins: TaskView['pins']): TaskView => ({
  name,
  module: name,
  library: 'l',
  order: 1,
  description: '',
  width: 136,
  height: 86,
  pins,
})

it('the type and unit of a variable are those of its writer, else of a reader', () => {
  const tasks = {
    pd: task('pd', [{ name: 'Q', svar: 'Q_MEZ', kind: 'INVAR', y: 0, shape: 'double[]', unit: '' }]),
    puma: task('puma', [{ name: 'Q', svar: 'Q_MEZ', kind: 'OUTVAR', y: 0, shape: 'double[6]', unit: 'rad' }]),
  }
  const doc: DocumentView = {
    name: 'd',
    order: 1,
    tasks: { pd: { x: 0, y: 0 }, puma: { x: 0, y: 0 } },
    loci: { Q_MEZ: { x: 0, y: 0 }, A: { x: 0, y: 0 } },
  }
  expect(variables(doc, tasks).map((row) => [row.name, row.type, row.unit])).toEqual([
    ['A', '', ''],
    ['Q_MEZ', 'double[6]', 'rad'],
  ])
  delete doc.tasks!.puma
  expect(variables(doc, tasks)[1].type).toBe('double[]')
})
