// R-D25: files are saved in places of the user's own.
import { expect, it } from 'vitest'
import { placesOf } from '../../src/files/places'

const library = (path: string, is_shipped = false) => ({ [path]: { name: path, path, order: 0, tasks: 0, is_shipped } })
const dictionary = (path: string, is_shipped = false) => ({
  [path]: { name: path, path, order: 0, onikons: 0, is_shipped },
})

it('offers what is open and does not come with Onika, each once', () => {
  const tree = {
    libraries: { ...library('/labs/box', true), ...library('/me') },
    dictionaries: { ...dictionary('/labs/box', true), ...dictionary('/me'), ...dictionary('/us') },
  }
  expect(placesOf(tree, '')).toEqual(['/me', '/us'])
})
it('offers first where the file lies', () => {
  expect(placesOf({ libraries: library('/me'), dictionaries: {} }, '/labs/box')).toEqual(['/labs/box', '/me'])
})
