"""Cameras, poses and boards."""

import numpy as np
import pytest

import runmark

CAMERA = runmark.Camera(600, 610, 319.5, 239.5, width=640, height=480)


def rotation(degrees_about_x, degrees_about_y):
    a, b = np.radians([degrees_about_x, degrees_about_y])
    about_x = [[1, 0, 0], [0, np.cos(a), -np.sin(a)], [0, np.sin(a), np.cos(a)]]
    about_y = [[np.cos(b), 0, np.sin(b)], [0, 1, 0], [-np.sin(b), 0, np.cos(b)]]
    return np.array(about_x) @ np.array(about_y)


def marker_points(size):
    return size / 2 * np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]])


def test_a_pose_from_exact_corners():
    turn, place = rotation(20, -35), np.array([0.1, -0.05, 1.2])
    corners = CAMERA.project(marker_points(0.2) @ turn.T + place)
    estimate = runmark.pose(corners, 0.2, CAMERA)
    best = estimate.best
    np.testing.assert_allclose(best.rotation, turn, atol=1e-5)
    np.testing.assert_allclose(best.translation, place, atol=1e-5)
    np.testing.assert_allclose(best.matrix, np.vstack([np.column_stack([turn, place]), [0, 0, 0, 1]]), atol=1e-5)
    assert best.error < 1e-4 and 0 <= estimate.ambiguity <= 1
    assert best.covariance.shape == (6, 6) and np.all(np.linalg.eigvalsh(best.covariance) > 0)
    angle = np.linalg.norm(best.rotation_vector)
    np.testing.assert_allclose(np.trace(turn), 1 + 2 * np.cos(angle), atol=1e-5)
    np.testing.assert_allclose(abs(best.quaternion[3]), np.cos(angle / 2), atol=1e-5)
    assert estimate.other is None or estimate.other.error > best.error
    assert repr(best).startswith("<Pose at 0.1")


def test_the_pose_of_a_marker_that_was_found():
    known = runmark.Dictionary("tag36h11")
    image = np.full((480, 640), 255, np.uint8)
    image[100:228, 250:378] = known.draw(5, 16, 0)
    marker = runmark.Detector(known).detect(image)[0]
    for picture in (image, None):
        best = runmark.pose(marker, 0.16, CAMERA, picture).best
        np.testing.assert_allclose(best.translation[:2] / best.translation[2],
                                   [(313.5 - 319.5) / 600, (163.5 - 239.5) / 610], atol=2e-3)
        np.testing.assert_allclose(best.translation[2], 0.16 * 605 / 128, rtol=0.02)


def test_cameras(tmp_path):
    points = np.array([[0.1, 0.2, 1], [-0.4, 0.1, 2], [0, 0, -1]])
    for lens, distortion in (("plain", [-0.2, 0.05, 0.001, -0.001, 0.01]), ("rational", [0.1] * 3 + [0] * 9),
                             ("fisheye", [0.01, -0.02, 0, 0])):
        camera = runmark.Camera(500, 500, 320, 240, lens=lens, distortion=distortion)
        pixels = camera.project(points)
        assert pixels.shape == (3, 2) and np.isnan(pixels[2]).all()
        np.testing.assert_allclose(camera.directions(pixels[:2]), points[:2, :2] / points[:2, 2:], atol=1e-6)
        assert camera.lens == lens and camera.distortion[:len(distortion)].tolist() == distortion
    np.testing.assert_array_equal(CAMERA.matrix, [[600, 0, 319.5], [0, 610, 239.5], [0, 0, 1]])
    text = ("image_width: 640\nimage_height: 480\ndistortion_model: plumb_bob\n"
            "camera_matrix: {rows: 3, cols: 3, data: [600, 0, 319.5, 0, 610, 239.5, 0, 0, 1]}\n"
            "distortion_coefficients: {rows: 1, cols: 5, data: [0.1, 0, 0, 0, 0]}\n")
    (tmp_path / "camera.yaml").write_text(text)
    for camera in (runmark.Camera.parse(text), runmark.Camera.load(tmp_path / "camera.yaml")):
        assert (camera.width, camera.height, camera.distortion[0]) == (640, 480, 0.1)
        np.testing.assert_array_equal(camera.matrix, CAMERA.matrix)


def charuco_picture(board, square=60, margin=40):
    """The board from the front, `square` pixels a square."""
    columns, rows = 5, 4
    image = np.full((rows * square + 2 * margin, columns * square + 2 * margin), 255, np.uint8)
    drawn = runmark.Dictionary("DICT_4X4_50")
    squares = {tuple((c[:, :2].mean(axis=0)).astype(int)): i for i, c in zip(board.ids, board.corners)}
    for y in range(rows):
        for x in range(columns):
            place = image[margin + y * square:margin + (y + 1) * square, margin + x * square:margin + (x + 1) * square]
            if (x, y) in squares:
                place[9:51, 9:51] = drawn.draw(squares[x, y], 7, 0)
            else:
                place[:] = 0
    return image


def test_a_charuco_board():
    board = runmark.Board.charuco("DICT_4X4_50", 5, 4, square=1, marker=0.7)
    assert len(board) == 10 and board.ids.tolist() == list(range(10))
    assert board.corners.shape == (10, 4, 3) and board.chess_corners.shape == (12, 3)
    assert (runmark.Board("charuco:DICT_4X4_50:5x4:1:0.7").corners == board.corners).all()
    image = charuco_picture(board)
    found = runmark.Detector("DICT_4X4_50").detect(image)
    assert board.advice(found) == ""
    view = board.view(found, image)
    assert sorted(view.ids.tolist()) == list(range(10)) and sorted(view.chess_ids.tolist()) == list(range(12))
    expected = 40 - 0.5 + 60 * board.chess_corners[view.chess_ids, :2]
    np.testing.assert_allclose(view.chess_corners, expected, atol=0.05)
    assert view.chess_deviations.shape == (12,) and (view.chess_deviations > 0).all()
    best = view.pose(runmark.Camera(600, 600, 200, 150)).best
    np.testing.assert_allclose(best.rotation, np.eye(3), atol=0.01)
    np.testing.assert_allclose(best.translation, [(39.5 - 200) / 60, (39.5 - 150) / 60, 10], atol=0.05)
    legacy = runmark.Board.charuco("DICT_4X4_50", 5, 4, 1, 0.7, legacy=True)
    assert "since" in legacy.advice(found) or "4.6" in legacy.advice(found)


def test_a_grid_board():
    board = runmark.Board.grid("DICT_4X4_50", 3, 2, marker=60, gap=20, first_id=4)
    assert board.ids.tolist() == [4, 5, 6, 7, 8, 9] and board.chess_corners.shape == (0, 3)
    image = np.full((240, 320), 255, np.uint8)
    drawn = runmark.Dictionary("DICT_4X4_50")
    for i, corners in zip(board.ids, board.corners):
        x, y = (corners[0, :2] + 30).astype(int)
        image[y:y + 60, x:x + 60] = drawn.draw(i, 10, 0)
    found = runmark.Detector("DICT_4X4_50").detect(image)
    best = board.view(found, image).pose(runmark.Camera(500, 500, 159.5, 119.5)).best
    np.testing.assert_allclose(best.translation, [29.5 - 159.5, 29.5 - 119.5, 500], atol=2)


@pytest.mark.parametrize("call, error, says", [
    (lambda: runmark.pose(np.zeros((3, 2)), 1, CAMERA), ValueError, r"marker: shape \(3, 2\), but it must be \(4, 2\)"),
    (lambda: runmark.pose("corners", 1, CAMERA), (TypeError, ValueError), ""),
    (lambda: runmark.pose(marker_points(9)[:, :2], 0, CAMERA), ValueError, "size"),
    (lambda: runmark.Camera(0, 600, 0, 0), ValueError, "no sense"),
    (lambda: runmark.Camera(1, 1, 0, 0, lens="round"), ValueError, "lens 'round'"),
    (lambda: runmark.Camera(1, 1, 0, 0, lens="fisheye", distortion=[0] * 5), ValueError, "5 numbers"),
    (lambda: runmark.Camera.load("/no/camera.yaml"), ValueError, "/no/camera.yaml"),
    (lambda: CAMERA.project([[1, 2]]), ValueError, r"points: shape \(1, 2\)"),
    (lambda: runmark.Board("circle"), ValueError, "board"),
    (lambda: runmark.Board.grid("DICT_4X4_50", 0, 1, 1, 1), ValueError, "0 x 1"),
    (lambda: runmark.Board.grid(["DICT_4X4_50", "tag36h11"], 1, 1, 1, 1), ValueError, "one is wanted"),
])
def test_what_makes_no_sense_is_refused(call, error, says):
    with pytest.raises(error, match=says):
        call()


def test_a_view_needs_its_image():
    board = runmark.Board.grid("DICT_4X4_50", 2, 2, 1, 1)
    blank = np.full((100, 100), 255, np.uint8)
    found = runmark.Detector("DICT_4X4_50").detect(blank)
    with pytest.raises(ValueError, match="another size"):
        board.view(found, blank[:50])
    with pytest.raises(ValueError, match="too little"):
        board.view(found, blank).pose(CAMERA)
