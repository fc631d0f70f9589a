// What the environment says as a bare text, in Spanish where that is known.
import { expect, test } from 'vitest'
import { heard } from '../../src/texts/heard'

test('a sentence that is known is said in Spanish, with what varies in it', () => {
  expect(heard('everything is stopped: aborted by the user', 'es')).toBe(
    'todo está parado: interrumpida por el usuario',
  )
})

test('a longer sentence that ends like a known one is not told half in Spanish', () => {
  const said = 'its data is asked for while it runs'
  expect(heard(said, 'es')).toBe(said)
})

test('what is not known stays as it was said, and English always does', () => {
  expect(heard('the sensor is dead', 'es')).toBe('the sensor is dead')
  expect(heard('aborted by the user', 'en')).toBe('aborted by the user')
})
