// Where the words of a remedy lead in an application.
import { beforeEach, expect, test, vi } from 'vitest'

vi.hoisted(() => vi.stubGlobal('navigator', { language: 'en' }))

const { desk, fullTree } = await import('../../src/link/desk.svelte')
const { here, pickSteps, reveal } = await import('../../src/state/here.svelte')

beforeEach(() => {
  desk.tree = fullTree({ applications: { a1: { name: 'one', order: 0 } }, documents: { c1: { name: 'two', order: 0 } } })
  Object.assign(here, { level: 'tasks', app: '', doc: 'c1', place: { flow: '0', after: 0 }, fitsOnly: false, dialog: { name: '', data: {} } })
  pickSteps()
})

test('a step is selected in its application, which comes to the front', () => { // R-X01
  reveal('step:17', 'a1')
  expect([...here.steps]).toEqual([17])
  expect([here.level, here.app, here.doc]).toEqual(['applications', 'a1', 'c1'])
  expect(here.wish).toMatchObject({ show: 'step:17', doc: 'a1' })
})

test('what fits somewhere is shown: the cursor goes there, the dictionary keeps what fits', () => { // R-X01
  reveal('fits:1/17/0:4', 'a1')
  expect(here.place).toEqual({ flow: '1/17/0', after: 4 })
  expect(here.fitsOnly).toBe(true)
})

test('a target is made, values are edited, an icon of the dictionary is selected', () => { // R-X01
  reveal('target:Joint object', 'a1')
  expect(here.dialog).toEqual({ name: 'target', data: { type: 'Joint object' } })
  reveal('values:3', 'a1')
  expect(here.dialog).toEqual({ name: 'icon', data: { step: '3' } })
  reveal('onikon:home', 'a1')
  expect(here.onikon).toBe('home')
})

test('words of the lower level lead there as before', () => {
  reveal('task:pd', 'c1')
  expect([...here.picked]).toEqual(['pd'])
  expect(here.doc).toBe('c1')
})
