// Where a remedy leads in an application.
import { beforeEach, expect, test, vi } from 'vitest'

vi.hoisted(() => vi.stubGlobal('navigator', { language: 'en' }))

const { desk, fullTree } = await import('../../src/link/desk.svelte')
const { destination, reveal } = await import('../../src/act/reveal.svelte')
const { canvas } = await import('../../src/state/canvas.svelte')
const { closeDialog, dialogs } = await import('../../src/state/dialogs.svelte')
const { look } = await import('../../src/state/look.svelte')
const { pickSteps, workspace } = await import('../../src/state/workspace.svelte')

beforeEach(() => {
  desk.tree = fullTree({
    applications: { a1: { name: 'one', order: 0 } },
    documents: { c1: { name: 'two', order: 0 } },
  })
  look.level = 'tasks'
  canvas.doc = 'c1'
  Object.assign(workspace, { app: '', place: { flow: '0', after: 0 }, fitsOnly: false })
  closeDialog()
  pickSteps()
})

test('a step is selected in its application, which comes to the front', () => {
  // R-X01
  reveal({ t: 'ShowStep', step: 17 }, 'a1')
  expect([...workspace.steps]).toEqual([17])
  expect([look.level, workspace.app, canvas.doc]).toEqual(['applications', 'a1', 'c1'])
  expect(destination).toMatchObject({ show: { t: 'ShowStep', step: 17 }, doc: 'a1' })
  expect(look.column).toBe('desk')
})

test('what fits somewhere is shown: the cursor goes there, the dictionary keeps what fits', () => {
  // R-X01
  reveal({ t: 'ShowFits', flow: '1/17/0', after: 4 }, 'a1')
  expect(workspace.place).toEqual({ flow: '1/17/0', after: 4 })
  expect(workspace.fitsOnly).toBe(true)
  expect(look.column).toBe('left') // of a narrow page
})

test('a target is made, values are edited, an icon of the dictionary is selected', () => {
  // R-X01
  reveal({ t: 'ShowTarget', type: 'Joint object' }, 'a1')
  expect(dialogs.current).toEqual({ name: 'target', data: { type: 'Joint object' } })
  reveal({ t: 'ShowValues', step: 3 }, 'a1')
  expect(dialogs.current).toEqual({ name: 'icon', data: { step: '3' } })
  reveal({ t: 'ShowOnikon', onikon: 'home' }, 'a1')
  expect(workspace.onikon).toBe('home')
})

test('a task is selected in its configuration, and the application stays as it was', () => {
  reveal({ t: 'ShowTask', task: 'pd' }, 'c1')
  expect([...canvas.picked]).toEqual(['pd'])
  expect(canvas.doc).toBe('c1')
})
