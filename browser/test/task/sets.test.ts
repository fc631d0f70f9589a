import { expect, it } from 'vitest'
import { isNow, setRows } from '../../src/task/sets'

const view = {
  path: '/own/conf/move.sets',
  present: [
    ['pd', 'STIFF', ['1']],
    ['pd', 'DAMP', ['1']],
  ] as [string, string, string[]][],
  sets: [
    {
      name: 'soft',
      values: [
        ['pd', 'STIFF', ['0.5']],
        ['gone', 'X', ['1']],
      ] as [string, string, string[]][],
    },
    { name: 'same', values: [['pd', 'STIFF', ['1']]] as [string, string, string[]][] },
  ],
}

it('sets stand side by side with what is now, and what differs is known', () => {
  expect(setRows(view)).toEqual([
    { task: 'pd', key: 'STIFF', present: '1', values: ['0.5', '1'], differs: true },
    { task: 'pd', key: 'DAMP', present: '1', values: [undefined, undefined], differs: false },
    { task: 'gone', key: 'X', present: undefined, values: ['1', undefined], differs: true },
  ])
})

it('a set is as now where its values of the tasks here are', () => {
  const rows = setRows(view)
  expect([isNow(rows, 0), isNow(rows, 1)]).toEqual([false, true])
})
