// What the environment sends, as the page takes it.
import { expect, test } from 'vitest'
import { message } from '../../src/link/message'

test('a reason that says nothing is left out, but where it fills a gap', () => {
  const nothing = { key: '', text: '' }
  const reason = { key: 'run.it_stands', text: 'it stands', args: { why: nothing } }
  const sent = { t: 'Patch', rev: 1, changes: [[['run'], { cause: nothing, note: reason, name: '' }]] }
  expect(message(JSON.stringify(sent))).toEqual({
    t: 'Patch',
    rev: 1,
    changes: [[['run'], { cause: undefined, note: reason, name: '' }]],
  })
})

test('a message without one is as it was sent', () => {
  const sent = { t: 'Ok', cid: 1, rev: 2, value: { key: '', other: [null, 1] } }
  expect(message(JSON.stringify(sent))).toEqual(sent)
})
