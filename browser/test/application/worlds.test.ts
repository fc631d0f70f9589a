import { expect, test } from 'vitest'
import type { ApplicationView, RunView, RuntimeView } from '../../src/api.gen'
import { drivenWorlds, toldWorlds, worldChoices, worldText } from '../../src/application/worlds'

const runtime = { world_kinds: { boxes: 'simulated', cell: 'real', 'boxes@flow0': 'simulated' } } as RuntimeView
const unknown = {} as RuntimeView
const app = (worlds: Record<string, string[]>): ApplicationView => ({ worlds }) as unknown as ApplicationView
const run = (...worlds: string[][]): RunView =>
  ({
    flows: Object.fromEntries(worlds.map((some, n) => [`flow${n}`, { order: n, worlds: some }])),
  }) as unknown as RunView

test('a world is called real or simulated where a runtime has said so', () => {
  expect(['boxes', 'boxes@mine', 'cell', 'sea'].map((world) => worldText(world, runtime))).toEqual([
    'boxes · simulated',
    'boxes@mine · simulated',
    'cell · real',
    'sea',
  ])
})

test('which world a flow drives is told where several are driven or a real one', () => {
  expect(toldWorlds(app({ flow0: ['boxes'], flow1: ['boxes'] }), 'flow0', runtime)).toEqual([])
  expect(toldWorlds(app({ flow0: ['boxes'], flow1: ['sea'] }), 'flow1', unknown)).toEqual(['sea'])
  expect(toldWorlds(app({ flow0: ['cell'] }), 'flow0', runtime)).toEqual(['cell'])
  expect(toldWorlds(undefined, 'flow0', runtime)).toEqual([])
})

test('so it is of a run', () => {
  expect(drivenWorlds(run(['boxes'], ['boxes']), 'flow0', runtime)).toEqual([])
  expect(drivenWorlds(run(['boxes'], ['cell']), 'flow0', runtime)).toEqual(['boxes'])
  expect(drivenWorlds(run(['boxes'], ['cell']), 'flow1', runtime)).toEqual(['cell'])
  expect(drivenWorlds(run(['boxes'], []), 'flow1', runtime)).toEqual([])
})

test('a simulated world may be copied, a real one only be left for another', () => {
  expect(worldChoices('boxes', 'boxes', 'flow1', runtime)).toEqual(['cell', 'boxes@flow1'])
  expect(worldChoices('boxes', 'boxes@mine', '', runtime)).toEqual(['cell', 'boxes@copy', 'boxes@mine'])
  expect(worldChoices('cell', 'boxes', '', runtime)).toEqual(['boxes'])
  expect(worldChoices('cell', '', '', unknown)).toEqual([])
})
