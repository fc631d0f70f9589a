import { beforeEach, expect, it } from 'vitest'
import { desk, fullTree } from '../../src/link/desk.svelte'
import { intoOf, stepOf, subsystemAt, subsystemOf, worksNow } from '../../src/progress/inside'

const task = (state: 'ON' | 'OFF' | 'ERROR') => ({ state })

beforeEach(() => {
  desk.tree = fullTree({
    run: {
      doc: 'a1',
      name: 'play',
      number: 1,
      state: 'running',
      flows: { flow0: { order: 0, step: 4 }, flow1: { order: 1, step: 9 } },
      steps_by_task: { 'flow0/puma': [2, 4], 'flow0/traj': [4], 'flow0/grip': [2], 'flow1/wait': [9] },
    },
    runtime: {
      inside: {
        flow0: { application: 'play', tasks: { grip: task('OFF'), puma: task('ON'), traj: task('ON') } },
        flow1: { application: 'play', tasks: { wait: task('ON') } },
      },
    },
    tasks: { traj: { name: 'traj', is_trigger: true } as never },
  })
})

it('the task that works now is the trigger of the present action', () => {
  expect([worksNow('flow0'), worksNow('flow1'), worksNow('elsewhere')]).toEqual(['traj', 'wait', ''])
})

it('a task of the present action that has failed comes before all that go on', () => {
  desk.live.runtime.inside!['flow0']!.tasks!['puma'] = task('ERROR')
  expect(worksNow('flow0')).toBe('puma')
})

it('a task leads to the icon that is carried out, else to the first in which it works', () => {
  expect([stepOf('flow0', 'puma'), stepOf('flow0', 'grip'), stepOf('flow1', 'wait'), stepOf('flow1', 'puma')]).toEqual([
    4, 2, 9, 0,
  ])
})

it('an icon leads to the flow that carries it out, else to the one that would', () => {
  expect([subsystemAt(9), subsystemAt(2), subsystemAt(77)]).toEqual(['flow1', 'flow0', ''])
})

it('what is not there any more is led to no longer', () => {
  desk.live.runtime.inside = {}
  expect([subsystemAt(4), worksNow('flow0')]).toEqual(['', ''])
})

it('a subsystem of a run is watched under a name that no document has', () => {
  expect([intoOf('flow0'), subsystemOf('@flow0'), subsystemOf('c1')]).toEqual(['@flow0', 'flow0', ''])
})
